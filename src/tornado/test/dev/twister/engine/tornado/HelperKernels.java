package dev.twister.engine.tornado;

import dev.twister.kernel.ClosestHit;
import dev.twister.kernel.Intersection;
import dev.twister.kernel.KernelMath;
import dev.twister.kernel.Layout;
import dev.twister.kernel.NearestHit;
import dev.twister.kernel.Shading;
import dev.twister.kernel.SkyLookup;
import dev.twister.kernel.SoftShadow;
import dev.twister.kernel.ToneMapping;
import dev.twister.kernel.ViewRay;
import java.util.function.Supplier;
import uk.ac.manchester.tornado.api.annotations.Parallel;

/**
 * A small kernel around each helper, to run on a device and, called as it is, on the JVM. None is named like a
 * function of OpenCL (floor, say): its driver would refuse it, and TornadoVM would run what is not there.
 */
public final class HelperKernels implements Supplier<HelperTasks> {
    @Override
    public HelperTasks get() {
        return HelperKernels::named;
    }

    private static HelperTask named(String helper) {
        return switch (helper) {
            case "floor" -> HelperKernels::floorItems;
            case "inverseRoot" -> HelperKernels::inverseRootItems;
            case "pow" -> HelperKernels::powItems;
            case "atan2" -> HelperKernels::atan2Items;
            case "viewRay" -> HelperKernels::viewRayItems;
            case "sphere" -> HelperKernels::sphereItems;
            case "plane" -> HelperKernels::planeItems;
            case "closestHit" -> HelperKernels::closestHitItems;
            case "nearestHit" -> HelperKernels::nearestHitItems;
            case "skyLookup" -> HelperKernels::skyLookupItems;
            case "shading" -> HelperKernels::shadingItems;
            case "toneMapping" -> HelperKernels::toneMappingItems;
            case "softShadow" -> HelperKernels::softShadowItems;
            default -> throw new IllegalArgumentException(helper);
        };
    }

    static void floorItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[i] = KernelMath.floor(in[i]);
        }
    }

    static void inverseRootItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[i] = KernelMath.inverseRoot(in[i]);
        }
    }

    static void powItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[i] = KernelMath.pow(in[2 * i], in[2 * i + 1]);
        }
    }

    static void atan2Items(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[i] = KernelMath.atan2(in[2 * i], in[2 * i + 1]);
        }
    }

    static void viewRayItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            int width = (int) in[4 * i + 2];
            int height = (int) in[4 * i + 3];
            out[2 * i] = ViewRay.u(in[4 * i], width, height);
            out[2 * i + 1] = ViewRay.v(in[4 * i + 1], width, height);
        }
    }

    static void sphereItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[i] = Intersection.sphere(
                    in[7 * i],
                    in[7 * i + 1],
                    in[7 * i + 2],
                    in[7 * i + 3],
                    in[7 * i + 4],
                    in[7 * i + 5],
                    in[7 * i + 6]);
        }
    }

    static void planeItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[i] = Intersection.plane(
                    in[8 * i],
                    in[8 * i + 1],
                    in[8 * i + 2],
                    in[8 * i + 3],
                    in[8 * i + 4],
                    in[8 * i + 5],
                    in[8 * i + 6],
                    in[8 * i + 7]);
        }
    }

    /** Item: origin, direction, the body that the ray leaves, how many bodies. Tables: positions, sizes. */
    static void closestHitItems(float[] in, float[] positions, float[] sizes, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            int body = ClosestHit.body(
                    in[8 * i],
                    in[8 * i + 1],
                    in[8 * i + 2],
                    in[8 * i + 3],
                    in[8 * i + 4],
                    in[8 * i + 5],
                    (int) in[8 * i + 6],
                    positions,
                    sizes,
                    (int) in[8 * i + 7]);
            float distance = Intersection.MISS;
            if (body >= 0) {
                distance = ClosestHit.distance(
                        body,
                        in[8 * i],
                        in[8 * i + 1],
                        in[8 * i + 2],
                        in[8 * i + 3],
                        in[8 * i + 4],
                        in[8 * i + 5],
                        positions,
                        sizes);
            }
            out[2 * i] = body;
            out[2 * i + 1] = distance;
        }
    }

    /** Item: origin, direction, the body that the ray leaves, the root. Tables: positions, sizes, hierarchy. */
    static void nearestHitItems(
            float[] in, float[] positions, float[] sizes, float[] hierarchy, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] scratch = new float[Layout.SCRATCH_LENGTH];
            int body = NearestHit.body(
                    in[8 * i],
                    in[8 * i + 1],
                    in[8 * i + 2],
                    in[8 * i + 3],
                    in[8 * i + 4],
                    in[8 * i + 5],
                    (int) in[8 * i + 6],
                    positions,
                    sizes,
                    hierarchy,
                    (int) in[8 * i + 7],
                    scratch);
            float distance = Intersection.MISS;
            if (body >= 0) {
                distance = ClosestHit.distance(
                        body,
                        in[8 * i],
                        in[8 * i + 1],
                        in[8 * i + 2],
                        in[8 * i + 3],
                        in[8 * i + 4],
                        in[8 * i + 5],
                        positions,
                        sizes);
            }
            out[2 * i] = body;
            out[2 * i + 1] = distance;
        }
    }

    /** Item: direction, width, height. Table: the panorama. */
    static void skyLookupItems(float[] in, float[] skybox, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            int width = (int) in[5 * i + 3];
            int height = (int) in[5 * i + 4];
            float column = SkyLookup.column(in[5 * i], in[5 * i + 2], width);
            float row = SkyLookup.row(in[5 * i], in[5 * i + 1], in[5 * i + 2], height);
            out[5 * i] = column;
            out[5 * i + 1] = row;
            out[5 * i + 2] = SkyLookup.radiance(skybox, width, height, column, row, 0);
            out[5 * i + 3] = SkyLookup.radiance(skybox, width, height, column, row, 1);
            out[5 * i + 4] = SkyLookup.radiance(skybox, width, height, column, row, 2);
        }
    }

    static void shadingItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[3 * i] = Shading.lit(in[6 * i], in[6 * i + 1], in[6 * i + 2]);
            out[3 * i + 1] =
                    Shading.specular(in[6 * i + 3], in[6 * i + 1], in[6 * i + 4], in[6 * i + 5], in[6 * i + 2]);
            out[3 * i + 2] = Shading.isEvenSquare(100f * in[6 * i + 1], 100f * in[6 * i + 4]);
        }
    }

    static void toneMappingItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[2 * i] = ToneMapping.quantized(in[4 * i], in[4 * i + 1], (int) in[4 * i + 2], in[4 * i + 3]);
            out[2 * i + 1] = ToneMapping.srgbEncoded(Math.min(in[4 * i], 1f));
        }
    }

    /** Item: point, own body, A, D, the disc's radius, samples, the root. Tables: unit disc, hierarchy. */
    static void softShadowItems(float[] in, float[] disc, float[] hierarchy, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] scratch = new float[Layout.SCRATCH_LENGTH];
            out[i] = SoftShadow.visible(
                    in[11 * i],
                    in[11 * i + 1],
                    in[11 * i + 2],
                    (int) in[11 * i + 3],
                    in[11 * i + 4],
                    in[11 * i + 5],
                    in[11 * i + 6],
                    in[11 * i + 7],
                    in[11 * i + 8],
                    (int) in[11 * i + 9],
                    disc,
                    hierarchy,
                    (int) in[11 * i + 10],
                    scratch);
        }
    }
}
