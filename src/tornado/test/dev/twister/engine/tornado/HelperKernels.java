package dev.twister.engine.tornado;

import dev.twister.kernel.CameraRay;
import dev.twister.kernel.Facet;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Illumination;
import dev.twister.kernel.Intersection;
import dev.twister.kernel.KernelMath;
import dev.twister.kernel.Layout;
import dev.twister.kernel.LightTree;
import dev.twister.kernel.MeshRay;
import dev.twister.kernel.Refraction;
import dev.twister.kernel.Shadow;
import dev.twister.kernel.ShadowRay;
import dev.twister.kernel.SkyLookup;
import dev.twister.kernel.Surface;
import dev.twister.kernel.SurfaceLook;
import dev.twister.kernel.Texture;
import dev.twister.kernel.Tone;
import dev.twister.kernel.Triangle;
import dev.twister.kernel.Variant;
import dev.twister.kernel.Views;
import java.util.function.Supplier;
import uk.ac.manchester.tornado.api.annotations.Parallel;

/**
 * A small kernel around each helper, to run on a device and, called directly, on the JVM. Names must not be those of
 * OpenCL functions such as floor: the driver would reject them, and TornadoVM would run a kernel that does not exist.
 */
public final class HelperKernels implements Supplier<HelperTasks> {
    /** Number of points of the light's disc for shadows of meshes. */
    static final int MESH_SAMPLES = 16;

    /** Outputs per item of {@link #meshItems} and {@link #meshShadowItems}. */
    static final int MESH_OUTPUTS = 13;

    static final int MESH_SHADOW_OUTPUTS = 2;

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
            case "viewport" -> HelperKernels::viewportItems;
            case "sphere" -> HelperKernels::sphereItems;
            case "plane" -> HelperKernels::planeItems;
            case "hit" -> HelperKernels::hitItems;
            case "walk" -> HelperKernels::walkItems;
            case "sky" -> HelperKernels::skyItems;
            case "light" -> HelperKernels::lightItems;
            case "tone" -> HelperKernels::toneItems;
            case "facet" -> HelperKernels::facetItems;
            case "refraction" -> HelperKernels::refractionItems;
            case "texture" -> HelperKernels::textureItems;
            case "shadow" -> HelperKernels::shadowItems;
            case "triangle" -> HelperKernels::triangleItems;
            case "mesh" -> HelperKernels::meshItems;
            case "meshShadow" -> HelperKernels::meshShadowItems;
            case "lightTree" -> HelperKernels::lightTreeItems;
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

    static void viewportItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            int width = (int) in[4 * i + 2];
            int height = (int) in[4 * i + 3];
            out[2 * i] = CameraRay.u(in[4 * i], width, height);
            out[2 * i + 1] = CameraRay.v(in[4 * i + 1], width, height);
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

    /** Item: origin, direction, body that the ray leaves, number of bodies. Tables: bodies, looks. */
    static void hitItems(float[] in, float[] bodies, float[] looks, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.PLAIN_SCRATCH_LENGTH];
            float[] frame = new float[Layout.DISC];
            int present = (int) in[8 * i + 7];
            frame[Layout.BODIES] = present;
            frame[Layout.ROOT] = Layout.PLACE_STRIDE * present + Layout.SPHERE_STRIDE * (present - Layout.FIRST_SPHERE);
            frame[Layout.SHADOW_ROOT] = frame[Layout.ROOT];
            path[Layout.ORIGIN] = in[8 * i];
            path[Layout.ORIGIN + 1] = in[8 * i + 1];
            path[Layout.ORIGIN + 2] = in[8 * i + 2];
            path[Layout.DIRECTION] = in[8 * i + 3];
            path[Layout.DIRECTION + 1] = in[8 * i + 4];
            path[Layout.DIRECTION + 2] = in[8 * i + 5];
            int leaving = (int) in[8 * i + 6];
            path[Layout.LEAVING] = leaving;
            if (leaving >= Layout.FIRST_SPHERE) {
                float transmission = looks[Layout.LOOK_STRIDE * leaving + Layout.LOOK_TRANSMISSION];
                path[Layout.INSIDE] = transmission > 0f ? 1f : 0f;
            }
            out[2 * i] = Hit.find(path, scratch, frame, bodies, looks, bodies, Variant.MATERIALS);
            out[2 * i + 1] = path[Layout.DISTANCE];
        }
    }

    /** Item: point, normal, number. Table: the frame's values, then the looks. */
    static void lightTreeItems(float[] in, float[] table, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.TRACED_PATH_LENGTH];
            float[] frame = new float[Layout.DISC];
            for (int k = 0; k < Layout.DISC; k++) {
                frame[k] = table[k];
            }
            path[Layout.TRANSMISSION] = 0f;
            path[Layout.POINT] = in[7 * i];
            path[Layout.POINT + 1] = in[7 * i + 1];
            path[Layout.POINT + 2] = in[7 * i + 2];
            path[Layout.ORIGIN] = in[7 * i];
            path[Layout.ORIGIN + 1] = in[7 * i + 1];
            path[Layout.ORIGIN + 2] = in[7 * i + 2];
            path[Layout.NORMAL] = in[7 * i + 3];
            path[Layout.NORMAL + 1] = in[7 * i + 4];
            path[Layout.NORMAL + 2] = in[7 * i + 5];
            int emitter = LightTree.choose(path, in[7 * i + 6], frame, table);
            int row = (int) frame[Layout.EMITTER_TABLE] + Layout.EMITTER_STRIDE * emitter;
            out[3 * i] = emitter;
            out[3 * i + 1] = path[Layout.CHOICE];
            out[3 * i + 2] = LightTree.probability(path, (int) table[row + Layout.EMITTER_LEAF], frame, table);
        }
    }

    /** As {@link #hitItems}, by traversal of the hierarchy. */
    static void walkItems(float[] in, float[] bodies, float[] looks, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.PLAIN_SCRATCH_LENGTH];
            float[] frame = new float[Layout.DISC];
            int present = (int) in[8 * i + 7];
            frame[Layout.BODIES] = present;
            frame[Layout.ROOT] = Layout.PLACE_STRIDE * present + Layout.SPHERE_STRIDE * (present - Layout.FIRST_SPHERE);
            frame[Layout.SHADOW_ROOT] = frame[Layout.ROOT];
            path[Layout.ORIGIN] = in[8 * i];
            path[Layout.ORIGIN + 1] = in[8 * i + 1];
            path[Layout.ORIGIN + 2] = in[8 * i + 2];
            path[Layout.DIRECTION] = in[8 * i + 3];
            path[Layout.DIRECTION + 1] = in[8 * i + 4];
            path[Layout.DIRECTION + 2] = in[8 * i + 5];
            int leaving = (int) in[8 * i + 6];
            path[Layout.LEAVING] = leaving;
            if (leaving >= Layout.FIRST_SPHERE) {
                float transmission = looks[Layout.LOOK_STRIDE * leaving + Layout.LOOK_TRANSMISSION];
                path[Layout.INSIDE] = transmission > 0f ? 1f : 0f;
            }
            out[2 * i] = Hit.find(path, scratch, frame, bodies, looks, bodies, Variant.MATERIALS | Variant.WALK);
            out[2 * i + 1] = path[Layout.DISTANCE];
        }
    }

    /** Item: direction, width, height. Table: the panorama. */
    static void skyItems(float[] in, float[] skybox, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            int width = (int) in[5 * i + 3];
            int height = (int) in[5 * i + 4];
            float column = SkyLookup.column(in[5 * i], in[5 * i + 2], 0f, width);
            float row = SkyLookup.row(in[5 * i], in[5 * i + 1], in[5 * i + 2], height);
            out[5 * i] = column;
            out[5 * i + 1] = row;
            out[5 * i + 2] = SkyLookup.radiance(width, height, column, row, 0, skybox);
            out[5 * i + 3] = SkyLookup.radiance(width, height, column, row, 1, skybox);
            out[5 * i + 4] = SkyLookup.radiance(width, height, column, row, 2, skybox);
        }
    }

    static void lightItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[3 * i] = Illumination.lit(in[6 * i], in[6 * i + 1], in[6 * i + 2]);
            out[3 * i + 1] =
                    Illumination.specular(in[6 * i + 3], in[6 * i + 1], in[6 * i + 4], in[6 * i + 5], in[6 * i + 2]);
            out[3 * i + 2] = SurfaceLook.isEvenSquare(100f * in[6 * i + 1], 100f * in[6 * i + 4]);
        }
    }

    static void toneItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[2 * i] = Tone.quantized(in[4 * i], in[4 * i + 1], (int) in[4 * i + 2], in[4 * i + 3]);
            out[2 * i + 1] = Tone.srgbEncoded(Math.min(in[4 * i], 1f));
        }
    }

    /** Item: direction, normal, roughness, column, row, bounce. Table: a frame, its pixel sample last. */
    static void facetItems(float[] in, float[] frame, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            path[Layout.DIRECTION] = in[10 * i];
            path[Layout.DIRECTION + 1] = in[10 * i + 1];
            path[Layout.DIRECTION + 2] = in[10 * i + 2];
            path[Layout.NORMAL] = in[10 * i + 3];
            path[Layout.NORMAL + 1] = in[10 * i + 4];
            path[Layout.NORMAL + 2] = in[10 * i + 5];
            path[Layout.ROUGHNESS] = in[10 * i + 6];
            path[Layout.PIXEL_COLUMN] = in[10 * i + 7];
            path[Layout.PIXEL_ROW] = in[10 * i + 8];
            path[Layout.PIXEL_SAMPLE] = Layout.DISC;
            path[Layout.BOUNCE] = in[10 * i + 9];
            Facet.find(path, frame);
            out[3 * i] = path[Layout.FACET];
            out[3 * i + 1] = path[Layout.FACET + 1];
            out[3 * i + 2] = path[Layout.FACET + 2];
        }
    }

    /** Item: two cosines, ratio of indices, roughness. */
    static void refractionItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[2 * i] = Refraction.reflectance(in[4 * i], in[4 * i + 2]);
            out[2 * i + 1] = Facet.weight(in[4 * i + 3], in[4 * i], in[4 * i + 1]);
        }
    }

    /** Item: column, row, width, height. Table: texels. */
    static void textureItems(float[] in, float[] texels, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            int width = (int) in[4 * i + 2];
            int height = (int) in[4 * i + 3];
            out[i] = Texture.color(3, 0, width, height, in[4 * i], in[4 * i + 1], i % 3, texels);
        }
    }

    /** Item: point, own body, A, D. Tables: frame, bodies, looks. */
    static void shadowItems(float[] in, float[] frame, float[] bodies, float[] looks, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.SCRATCH_RAYS];
            path[Layout.POINT] = in[8 * i];
            path[Layout.POINT + 1] = in[8 * i + 1];
            path[Layout.POINT + 2] = in[8 * i + 2];
            path[Layout.TO_LIGHT] = in[8 * i + 4];
            path[Layout.TO_LIGHT + 1] = in[8 * i + 5];
            path[Layout.TO_LIGHT + 2] = in[8 * i + 6];
            path[Layout.LIGHT_DISTANCE] = in[8 * i + 7];
            path[Layout.NORMAL_DOT_LIGHT] = 1f;
            out[i] =
                    Shadow.visible(path, (int) in[8 * i + 3], scratch, frame, bodies, looks, bodies, Variant.MATERIALS);
        }
    }

    /** Item: origin, direction, three corners. Table: an instance. */
    static void triangleItems(float[] in, float[] instance, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            MeshRay.enter(
                    path,
                    0,
                    in[15 * i],
                    in[15 * i + 1],
                    in[15 * i + 2],
                    in[15 * i + 3],
                    in[15 * i + 4],
                    in[15 * i + 5],
                    instance);
            out[2 * i] = path[Layout.MESH_AXIS];
            out[2 * i + 1] = Triangle.distance(path, 15 * i + 6, in);
        }
    }

    /** Item: origin, direction, triangle that the ray leaves. Tables: frame, bodies, meshes. */
    static void meshItems(float[] in, float[] frame, float[] bodies, float[] meshes, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.SCRATCH_RAYS];
            int body = meetMesh(in, i, frame, bodies, meshes, path, scratch);
            out[MESH_OUTPUTS * i] = body;
            out[MESH_OUTPUTS * i + 1] = path[Layout.DISTANCE];
            for (int axis = 0; axis < 3; axis++) {
                out[MESH_OUTPUTS * i + 2 + axis] = path[Layout.POINT + axis];
                out[MESH_OUTPUTS * i + 5 + axis] = path[Layout.NORMAL + axis];
                out[MESH_OUTPUTS * i + 8 + axis] = path[Layout.FACE + axis];
            }
            out[MESH_OUTPUTS * i + 11] = path[Layout.TEXTURE_PLACE];
            out[MESH_OUTPUTS * i + 12] = path[Layout.TEXTURE_PLACE + 1];
        }
    }

    /** Item: as in {@link #meshItems}. Tables: frame with the looks of all bodies behind it, bodies, meshes. */
    static void meshShadowItems(float[] in, float[] frame, float[] bodies, float[] meshes, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.SCRATCH_RAYS];
            float[] looks = new float[5 * Layout.LOOK_STRIDE];
            for (int k = 0; k < 5 * Layout.LOOK_STRIDE; k++) {
                looks[k] = frame[Layout.DISC + 2 * MESH_SAMPLES + k];
            }
            int body = meetMesh(in, i, frame, bodies, meshes, path, scratch);
            float visible = -1f;
            float light = -1f;
            if (body != Layout.NOTHING) {
                Illumination.aim(path, Layout.LIGHT, bodies);
                int variant = Variant.MATERIALS | Variant.MESHES | Variant.of(Views.SHADOW);
                visible = Shadow.visible(path, body, scratch, frame, bodies, looks, meshes, variant);
                light = ShadowRay.light(path, body, i % MESH_SAMPLES, scratch, frame, bodies, looks, meshes, variant);
            }
            out[MESH_SHADOW_OUTPUTS * i] = visible;
            out[MESH_SHADOW_OUTPUTS * i + 1] = light;
        }
    }

    /** Returns the mesh that the item's ray hits; clears the path first, as a device's starts uninitialized. */
    private static int meetMesh(
            float[] in, int i, float[] frame, float[] bodies, float[] meshes, float[] path, float[] scratch) {
        for (int k = 0; k < Layout.PATH_LENGTH; k++) {
            path[k] = 0f;
        }
        path[Layout.ORIGIN] = in[7 * i];
        path[Layout.ORIGIN + 1] = in[7 * i + 1];
        path[Layout.ORIGIN + 2] = in[7 * i + 2];
        path[Layout.DIRECTION] = in[7 * i + 3];
        path[Layout.DIRECTION + 1] = in[7 * i + 4];
        path[Layout.DIRECTION + 2] = in[7 * i + 5];
        path[Layout.LEAVING] = frame[Layout.FIRST_MESH];
        path[Layout.LEAVING_TRIANGLE] = in[7 * i + 6];
        int variant = Variant.MATERIALS | Variant.MESHES;
        int body = Hit.find(path, scratch, frame, bodies, bodies, meshes, variant);
        if (body != Layout.NOTHING) {
            Surface.find(path, body, frame, bodies, meshes, variant);
        }
        return body;
    }
}
