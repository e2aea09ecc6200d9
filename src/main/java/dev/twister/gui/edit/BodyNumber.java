package dev.twister.gui.edit;

import dev.twister.kernel.Layout;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.TrackTarget;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;

/**
 * The window's numbers of a scene's bodies: the plane and the spheres are numbered as in {@code FrameInput}. A mesh is
 * one body here, but one per part in a {@code FrameInput}.
 */
public final class BodyNumber {
    /** No body: the sky is seen there, or nothing is selected. */
    public static final int NONE = Layout.NOTHING;

    public static final int PLANE = Layout.PLANE;

    /**
     * The first light: beyond all spheres, poured ones included, so that lights keep their numbers while spheres come
     * and go.
     */
    public static final int LIGHT = 1 << 23;

    /** Beyond all spheres and lights. */
    private static final int FIRST_MESH = 1 << 24;

    private BodyNumber() {}

    /** The number of the light at that place of the scene's list. */
    public static int ofLight(int index) {
        return LIGHT + index;
    }

    /** The light's place in the scene's list; below 0 for what is no light, and beyond the list for a mesh. */
    public static int light(int body) {
        return body < LIGHT ? NONE : body - LIGHT;
    }

    /** The number of the sphere at that place of the scene's list. */
    public static int ofSphere(int index) {
        return Layout.FIRST_SPHERE + index;
    }

    /** The sphere's place in the scene's list; below 0 for what is no sphere, and beyond the list for others. */
    public static int sphere(int body) {
        return body - Layout.FIRST_SPHERE;
    }

    /** The number of the mesh at that place of the scene's list. */
    public static int ofMesh(int index) {
        return FIRST_MESH + index;
    }

    /** The mesh's place in the scene's list; below 0 for what is no mesh. */
    public static int mesh(int body) {
        return body - FIRST_MESH;
    }

    /**
     * The body of a picture's scene that has a number in the picture.
     *
     * @param scene of the picture
     * @param meshes that the picture shows
     */
    public static int inScene(int pictured, FrameInput input, Scene scene, SceneMeshes meshes) {
        if (input.isLight(pictured)) {
            return ofLight(input.lightIndex(pictured));
        }
        int firstMesh = input.bodies().firstMesh();
        if (firstMesh == Layout.NO_MESHES || pictured < firstMesh) {
            return pictured;
        }
        int part = pictured - firstMesh;
        for (int index = 0; index < scene.meshes().size(); index++) {
            Mesh mesh = scene.meshes().get(index);
            int parts = meshes.holds(mesh) ? meshes.parts(mesh) : 0;
            if (part < parts) {
                return ofMesh(index);
            }
            part -= parts;
        }
        return NONE;
    }

    /** The body that a target is; {@link #NONE} for the camera, the sky and the like. */
    public static int of(TrackTarget target) {
        return switch (target.kind()) {
            case LIGHT -> ofLight(target.index());
            case PLANE -> PLANE;
            case SPHERE -> ofSphere(target.index());
            case MESH -> ofMesh(target.index());
            case CAMERA, SKY, SHADING, RENDERING -> NONE;
        };
    }
}
