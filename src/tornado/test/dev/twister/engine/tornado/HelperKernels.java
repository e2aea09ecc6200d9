package dev.twister.engine.tornado;

import dev.twister.kernel.Aspect;
import dev.twister.kernel.Camera;
import dev.twister.kernel.Facet;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Intersection;
import dev.twister.kernel.KernelMath;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Light;
import dev.twister.kernel.Material;
import dev.twister.kernel.Refraction;
import dev.twister.kernel.Shadow;
import dev.twister.kernel.Sky;
import dev.twister.kernel.Surface;
import dev.twister.kernel.Texture;
import dev.twister.kernel.Tone;
import java.util.function.Supplier;
import uk.ac.manchester.tornado.api.annotations.Parallel;

/**
 * A small kernel around each helper, to run on a device and, called as it is, on the JVM. None is named like a function
 * of OpenCL (floor, say): its driver would refuse it, and TornadoVM would run what is not there.
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
            case "mesh" -> HelperKernels::meshItems;
            case "meshShadow" -> HelperKernels::meshShadowItems;
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
            out[2 * i] = Camera.u(in[4 * i], width, height);
            out[2 * i + 1] = Camera.v(in[4 * i + 1], width, height);
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

    /** Item: origin, direction, the body that the ray leaves, how many bodies. Tables: places, hierarchy, looks. */
    static void hitItems(float[] in, float[] places, float[] hierarchy, float[] looks, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.PLAIN_SCRATCH_LENGTH];
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
            out[2 * i] = Hit.find(
                    path,
                    places,
                    looks,
                    hierarchy,
                    hierarchy,
                    (int) in[8 * i + 7],
                    scratch,
                    Hit.ALL,
                    Layout.NO_MESHES,
                    Material.ANY,
                    Aspect.FULL);
            out[2 * i + 1] = path[Layout.DISTANCE];
        }
    }

    /** The same by the hierarchy. */
    static void walkItems(float[] in, float[] places, float[] hierarchy, float[] looks, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.PLAIN_SCRATCH_LENGTH];
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
            out[2 * i] = Hit.find(
                    path,
                    places,
                    looks,
                    hierarchy,
                    hierarchy,
                    (int) in[8 * i + 7],
                    scratch,
                    Hit.WALK,
                    Layout.NO_MESHES,
                    Material.ANY,
                    Aspect.FULL);
            out[2 * i + 1] = path[Layout.DISTANCE];
        }
    }

    /**
     * Item: origin, direction, the triangle of the first mesh that the ray leaves, the first mesh's body. Tables:
     * hierarchy, meshes.
     */
    static void meshItems(float[] in, float[] hierarchy, float[] meshes, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.SCRATCH_LENGTH];
            int firstMesh = (int) in[8 * i + 7];
            path[Layout.ORIGIN] = in[8 * i];
            path[Layout.ORIGIN + 1] = in[8 * i + 1];
            path[Layout.ORIGIN + 2] = in[8 * i + 2];
            path[Layout.DIRECTION] = in[8 * i + 3];
            path[Layout.DIRECTION + 1] = in[8 * i + 4];
            path[Layout.DIRECTION + 2] = in[8 * i + 5];
            path[Layout.LEAVING] = firstMesh;
            path[Layout.LEAVING_TRIANGLE] = in[8 * i + 6];
            int body = Hit.find(
                    path,
                    hierarchy,
                    hierarchy,
                    hierarchy,
                    meshes,
                    0,
                    scratch,
                    Hit.ALL,
                    firstMesh,
                    Material.ANY,
                    Aspect.FULL);
            if (body != Layout.NOTHING) {
                Surface.find(path, body, hierarchy, hierarchy, meshes, firstMesh);
            }
            out[5 * i] = body;
            out[5 * i + 1] = path[Layout.DISTANCE];
            out[5 * i + 2] = path[Layout.NORMAL];
            out[5 * i + 3] = path[Layout.NORMAL + 1];
            out[5 * i + 4] = path[Layout.POINT];
        }
    }

    /**
     * Item: point, own body, A, D, the disc's radius, samples, the first mesh's body. Tables: unit disc, hierarchy,
     * meshes.
     */
    static void meshShadowItems(float[] in, float[] disc, float[] hierarchy, float[] meshes, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.SCRATCH_RAYS];
            float[] places = new float[2 * Layout.PLACE_STRIDE];
            float[] properties = new float[Layout.PROPERTIES_LENGTH];
            int firstMesh = (int) in[11 * i + 10];
            path[Layout.POINT] = in[11 * i];
            path[Layout.POINT + 1] = in[11 * i + 1];
            path[Layout.POINT + 2] = in[11 * i + 2];
            path[Layout.TO_LIGHT] = in[11 * i + 4];
            path[Layout.TO_LIGHT + 1] = in[11 * i + 5];
            path[Layout.TO_LIGHT + 2] = in[11 * i + 6];
            path[Layout.LIGHT_DISTANCE] = in[11 * i + 7];
            path[Layout.NORMAL_DOT_LIGHT] = 1f;
            places[Layout.PLACE_SIZE] = 0.5f * in[11 * i + 8];
            properties[Layout.SHADOW_SAMPLES] = in[11 * i + 9];
            properties[Layout.AMBIENT] = 0f;
            out[i] = Shadow.visible(
                    path,
                    (int) in[11 * i + 3],
                    properties,
                    places,
                    hierarchy,
                    disc,
                    hierarchy,
                    Layout.root(firstMesh),
                    meshes,
                    scratch,
                    firstMesh,
                    Material.PLAIN,
                    Aspect.FULL);
        }
    }

    /** Item: direction, width, height. Table: the panorama. */
    static void skyItems(float[] in, float[] skybox, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            int width = (int) in[5 * i + 3];
            int height = (int) in[5 * i + 4];
            float column = Sky.column(in[5 * i], in[5 * i + 2], 0f, width);
            float row = Sky.row(in[5 * i], in[5 * i + 1], in[5 * i + 2], height);
            out[5 * i] = column;
            out[5 * i + 1] = row;
            out[5 * i + 2] = Sky.radiance(skybox, width, height, column, row, 0);
            out[5 * i + 3] = Sky.radiance(skybox, width, height, column, row, 1);
            out[5 * i + 4] = Sky.radiance(skybox, width, height, column, row, 2);
        }
    }

    static void lightItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[3 * i] = Light.lit(in[6 * i], in[6 * i + 1], in[6 * i + 2]);
            out[3 * i + 1] = Light.specular(in[6 * i + 3], in[6 * i + 1], in[6 * i + 4], in[6 * i + 5], in[6 * i + 2]);
            out[3 * i + 2] = Material.isEvenSquare(100f * in[6 * i + 1], 100f * in[6 * i + 4]);
        }
    }

    static void toneItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            out[2 * i] = Tone.quantized(in[4 * i], in[4 * i + 1], (int) in[4 * i + 2], in[4 * i + 3]);
            out[2 * i + 1] = Tone.srgbEncoded(Math.min(in[4 * i], 1f));
        }
    }

    /** Item: direction, normal, roughness, column, row, bounce. Table: one pixel sample. */
    static void facetItems(float[] in, float[] samples, float[] b, float[] c, float[] out, int count) {
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
            Facet.find(path, (int) in[10 * i + 9], samples);
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
            out[i] = Texture.color(texels, 3, width, height, in[4 * i], in[4 * i + 1], i % 3);
        }
    }

    /** Item: point, own body, A, D, the disc's radius, samples, the root. Tables: unit disc, hierarchy, looks. */
    static void shadowItems(float[] in, float[] disc, float[] hierarchy, float[] looks, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.SCRATCH_RAYS];
            float[] places = new float[2 * Layout.PLACE_STRIDE];
            float[] properties = new float[Layout.PROPERTIES_LENGTH];
            path[Layout.POINT] = in[11 * i];
            path[Layout.POINT + 1] = in[11 * i + 1];
            path[Layout.POINT + 2] = in[11 * i + 2];
            path[Layout.TO_LIGHT] = in[11 * i + 4];
            path[Layout.TO_LIGHT + 1] = in[11 * i + 5];
            path[Layout.TO_LIGHT + 2] = in[11 * i + 6];
            path[Layout.LIGHT_DISTANCE] = in[11 * i + 7];
            path[Layout.NORMAL_DOT_LIGHT] = 1f;
            places[Layout.PLACE_SIZE] = 0.5f * in[11 * i + 8];
            properties[Layout.SHADOW_SAMPLES] = in[11 * i + 9];
            properties[Layout.AMBIENT] = 0f;
            out[i] = Shadow.visible(
                    path,
                    (int) in[11 * i + 3],
                    properties,
                    places,
                    looks,
                    disc,
                    hierarchy,
                    (int) in[11 * i + 10],
                    hierarchy,
                    scratch,
                    Layout.NO_MESHES,
                    Material.ANY,
                    Aspect.FULL);
        }
    }
}
