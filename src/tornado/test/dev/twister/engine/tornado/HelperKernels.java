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
import dev.twister.kernel.ShadowRay;
import dev.twister.kernel.Sky;
import dev.twister.kernel.Surface;
import dev.twister.kernel.Texture;
import dev.twister.kernel.Tone;
import dev.twister.kernel.Triangle;
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

    /** Item: origin, direction, body that the ray leaves, number of bodies. Tables: places, hierarchy, looks. */
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

    /** As {@link #hitItems}, by traversal of the hierarchy. */
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

    /** Item: origin, direction, three corners. */
    static void triangleItems(float[] in, float[] a, float[] b, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float x = in[15 * i + 3];
            float y = in[15 * i + 4];
            float z = in[15 * i + 5];
            int axis = Triangle.longestAxis(x, y, z);
            int first = Triangle.after(axis);
            int second = Triangle.after(first);
            float inverse = 1f / Triangle.along(axis, x, y, z);
            out[2 * i] = axis;
            out[2 * i + 1] = Triangle.distance(
                    in,
                    15 * i + 6,
                    axis,
                    in[15 * i + first],
                    in[15 * i + second],
                    in[15 * i + axis],
                    Triangle.along(first, x, y, z) * inverse,
                    Triangle.along(second, x, y, z) * inverse,
                    inverse);
        }
    }

    /** Item: origin, direction, first mesh's body, triangle that the ray leaves. Tables: hierarchy, meshes. */
    static void meshItems(float[] in, float[] hierarchy, float[] meshes, float[] c, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.SCRATCH_RAYS];
            int firstMesh = (int) in[8 * i + 6];
            int body = meetMesh(in, i, firstMesh, hierarchy, meshes, path, scratch);
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

    /**
     * Item: as in {@link #meshItems}. Tables: hierarchy, meshes, then looks of three meshes after points of the disc.
     */
    static void meshShadowItems(
            float[] in, float[] hierarchy, float[] meshes, float[] discAndLooks, float[] out, int count) {
        for (@Parallel int i = 0; i < count; i++) {
            float[] path = new float[Layout.PATH_LENGTH];
            float[] scratch = new float[Layout.SCRATCH_RAYS];
            float[] places = new float[2 * Layout.PLACE_STRIDE];
            float[] properties = new float[Layout.PROPERTIES_LENGTH];
            float[] looks = new float[5 * Layout.LOOK_STRIDE];
            places[0] = 2f;
            places[1] = 5f;
            places[2] = -3f;
            places[Layout.PLACE_SIZE] = 0.5f;
            // A plane out of the way.
            places[Layout.PLACE_STRIDE] = 0f;
            places[Layout.PLACE_STRIDE + 1] = -90f;
            places[Layout.PLACE_STRIDE + 2] = 0f;
            places[Layout.PLACE_STRIDE + Layout.PLACE_SIZE] = 1f;
            properties[Layout.SHADOW_SAMPLES] = MESH_SAMPLES;
            properties[Layout.AMBIENT] = 0f;
            for (int k = 0; k < 5 * Layout.LOOK_STRIDE; k++) {
                looks[k] = discAndLooks[2 * MESH_SAMPLES + k];
            }
            int firstMesh = (int) in[8 * i + 6];
            int body = meetMesh(in, i, firstMesh, hierarchy, meshes, path, scratch);
            float visible = -1f;
            float light = -1f;
            if (body != Layout.NOTHING) {
                Light.aim(path, places);
                int root = Layout.root(Layout.FIRST_SPHERE);
                visible = Shadow.visible(
                        path,
                        body,
                        properties,
                        places,
                        looks,
                        discAndLooks,
                        hierarchy,
                        root,
                        meshes,
                        scratch,
                        firstMesh,
                        Material.ANY,
                        Aspect.SHADOW);
                light = ShadowRay.light(
                        path,
                        body,
                        i % MESH_SAMPLES,
                        properties,
                        places,
                        looks,
                        discAndLooks,
                        hierarchy,
                        root,
                        meshes,
                        scratch,
                        firstMesh,
                        Material.ANY);
            }
            out[MESH_SHADOW_OUTPUTS * i] = visible;
            out[MESH_SHADOW_OUTPUTS * i + 1] = light;
        }
    }

    /** Returns the body that the item's ray hits; clears arrays first, as a device's start uninitialized. */
    private static int meetMesh(
            float[] in, int i, int firstMesh, float[] hierarchy, float[] meshes, float[] path, float[] scratch) {
        for (int k = 0; k < Layout.PATH_LENGTH; k++) {
            path[k] = 0f;
        }
        path[Layout.ORIGIN] = in[8 * i];
        path[Layout.ORIGIN + 1] = in[8 * i + 1];
        path[Layout.ORIGIN + 2] = in[8 * i + 2];
        path[Layout.DIRECTION] = in[8 * i + 3];
        path[Layout.DIRECTION + 1] = in[8 * i + 4];
        path[Layout.DIRECTION + 2] = in[8 * i + 5];
        path[Layout.LEAVING] = firstMesh;
        path[Layout.LEAVING_TRIANGLE] = in[8 * i + 7];
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
        return body;
    }
}
