package dev.twister.gui.picking;

import dev.twister.gui.edit.BodyExtent;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;

/** The spheres, meshes and lights that the user inserts, see {@link FreePlace}. */
public final class NewBodies {
    static final double RADIUS = 1.5;
    private static final double REFLECTIVITY = 32;

    /** Turns of the hue from one body to the next, so that neighbors differ. */
    private static final double GOLDEN_RATIO = 0.6180339887;

    private static final double LIGHT_RADIUS = 0.25;

    /** Over the ground, in meters: above a new body that stands there. */
    private static final double LIGHT_HEIGHT = 3.25;

    /** As large as the Earth's, over the camera's right shoulder at yaw 0. */
    private static final Light SUN = Light.sun(new Vector3(-0.5, -1, 0.5), 0.53);

    private NewBodies() {}

    /** A new shape of the usual proportions, made of what a new sphere would be. */
    public static Mesh mesh(FrameInput input, Scene scene, SceneMeshes meshes, Shape.Kind kind) {
        Shape shape = Shape.of(kind, 2 * RADIUS);
        return Mesh.of(shape)
                .withMaterial(material(scene))
                .withPosition(middle(input, scene, meshes, shape.size().times(0.5)));
    }

    /**
     * The mesh with a place and a scale.
     *
     * @param bounds of the file's triangles, in its own coordinates
     */
    public static Mesh mesh(FrameInput input, Scene scene, SceneMeshes meshes, Mesh mesh, BodyExtent bounds) {
        Vector3 half = bounds.half();
        double largest = Math.max(half.x(), Math.max(half.y(), half.z()));
        double scale = SceneLimits.FACTOR.clamp(largest > 0 ? RADIUS / largest : 1);
        Vector3 middle = middle(input, scene, meshes, half.times(scale));
        return mesh.withScale(scale)
                .withPosition(
                        SceneLimits.POSITION.clamp(middle.minus(bounds.middle().times(scale))));
    }

    private static Vector3 middle(FrameInput input, Scene scene, SceneMeshes meshes, Vector3 half) {
        return FreePlace.of(input, scene, meshes, BodyExtent.box(Vector3.ZERO, half));
    }

    /** A sphere in a color that differs from those of its neighbors. */
    public static Sphere sphere(FrameInput input, Scene scene, SceneMeshes meshes) {
        Vector3 place = FreePlace.of(input, scene, meshes, BodyExtent.ball(Vector3.ZERO, RADIUS));
        return Sphere.of(place, RADIUS, material(scene));
    }

    /** That of the next body. */
    static Material material(Scene scene) {
        double hue = (scene.spheres().size() + scene.meshes().size()) * GOLDEN_RATIO;
        Rgb color = new Rgb(channel(hue), channel(hue + 1.0 / 3), channel(hue + 2.0 / 3));
        return Material.DEFAULT.withColor(color).withReflectivity(REFLECTIVITY);
    }

    private static double channel(double turns) {
        return 0.5 + 0.4 * Math.cos(2 * Math.PI * turns);
    }

    /** A white light; a small one is below the ground where the camera is. */
    public static Light light(FrameInput input, Scene scene, SceneMeshes meshes, LightShape.Kind kind) {
        Vector3 raised = new Vector3(0, LIGHT_HEIGHT, 0);
        Vector3 place = FreePlace.of(input, scene, meshes, BodyExtent.ball(raised, LIGHT_RADIUS));
        return switch (kind) {
            case SPHERE -> Light.of(place, LIGHT_RADIUS, new Rgb(1, 1, 1));
            case SUN -> SUN;
            case SPOT -> Light.spot(place, LIGHT_RADIUS, new Vector3(0, -1, 0), 60);
        };
    }
}
