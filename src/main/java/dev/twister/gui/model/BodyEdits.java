package dev.twister.gui.model;

import dev.twister.gui.model.NumberSetting.Scale;
import dev.twister.scene.Pour;
import dev.twister.scene.Range;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;

/** Edits of a scene's spheres, by their {@link BodyNumber}. */
public final class BodyEdits {
    /** Of a radius, from one center to the other. */
    private static final double APART = 2.2;

    private BodyEdits() {}

    /** Whether a scene has a sphere of that number. */
    public static boolean isSphere(Scene scene, int body) {
        int index = BodyNumber.sphere(body);
        return index >= 0 && index < scene.spheres().size();
    }

    /** Whether it is a sphere that comes while bodies move, and can be looked at, but not edited. */
    public static boolean isPoured(Scene scene, int body) {
        int index = BodyNumber.sphere(body) - scene.spheres().size();
        return index >= 0 && index < scene.pour().map(Pour::count).orElse(0);
    }

    /** Whether the body can be selected and edited: the light, the plane and the spheres. */
    public static boolean isEditable(Scene scene, int body) {
        return body == BodyNumber.LIGHT || body == BodyNumber.PLANE || isSphere(scene, body);
    }

    /** Whether the body can be taken and moved: the light and the spheres. */
    public static boolean isMovable(Scene scene, int body) {
        return body == BodyNumber.LIGHT || isSphere(scene, body);
    }

    /**
     * The body so many steps on in the round of nothing, the light, the plane, and all spheres in their order.
     *
     * @param body where the round begins: {@link BodyNumber#NONE} or an editable body
     * @param steps back where they are negative
     */
    public static int along(Scene scene, int body, int steps) {
        int from = isEditable(scene, body) ? body : BodyNumber.NONE;
        int bodies = BodyNumber.ofSphere(scene.spheres().size());
        // In the order of their numbers, of which that of nothing comes first.
        return BodyNumber.NONE + Math.floorMod(from - BodyNumber.NONE + steps, bodies - BodyNumber.NONE);
    }

    public static Sphere sphere(Scene scene, int body) {
        return scene.spheres().get(BodyNumber.sphere(body));
    }

    /** The center of a movable body. */
    public static Vector3 position(Scene scene, int body) {
        return body == BodyNumber.LIGHT
                ? scene.light().position()
                : sphere(scene, body).position();
    }

    /** The radius of a movable body. */
    public static double radius(Scene scene, int body) {
        return body == BodyNumber.LIGHT
                ? scene.light().radius()
                : sphere(scene, body).radius();
    }

    /** The scene with a movable body elsewhere. */
    public static Scene moved(Scene scene, int body, Vector3 position) {
        if (body == BodyNumber.LIGHT) {
            return scene.withLight(scene.light().withPosition(position));
        }
        return edited(scene, body, sphere -> sphere.withPosition(position));
    }

    /** The scene with one sphere more, which is the last. */
    public static Scene inserted(Scene scene, Sphere sphere) {
        List<Sphere> spheres = new ArrayList<>(scene.spheres());
        spheres.add(sphere);
        return scene.withSpheres(spheres);
    }

    /** The same sphere to the right of it, so that they do not touch. */
    public static Sphere beside(Sphere sphere) {
        Vector3 place = sphere.position();
        double right = SceneLimits.POSITION.clamp(place.x() + APART * sphere.radius());
        return sphere.withPosition(new Vector3(right, place.y(), place.z()));
    }

    public static Scene deleted(Scene scene, int body) {
        List<Sphere> spheres = new ArrayList<>(scene.spheres());
        spheres.remove(BodyNumber.sphere(body));
        return scene.withSpheres(spheres);
    }

    public static NumberSetting x(int body) {
        return place(body, "x", "from left to right", Vector3::x, (place, x) -> new Vector3(x, place.y(), place.z()));
    }

    public static NumberSetting y(int body) {
        return place(body, "y", "in height", Vector3::y, (place, y) -> new Vector3(place.x(), y, place.z()));
    }

    public static NumberSetting z(int body) {
        return place(body, "z", "from near to far", Vector3::z, (place, z) -> new Vector3(place.x(), place.y(), z));
    }

    public static NumberSetting radiusOf(int body) {
        return new NumberSetting(
                "Sphere radius",
                "The sphere's radius.",
                SceneLimits.LENGTH,
                new Range(0.05, 10),
                Scale.LOGARITHMIC,
                2,
                "m",
                scene -> sphere(scene, body).radius(),
                (scene, radius) -> edited(scene, body, sphere -> sphere.withRadius(radius)));
    }

    private static NumberSetting place(
            int body,
            String axis,
            String direction,
            ToDoubleFunction<Vector3> reader,
            BiFunction<Vector3, Double, Vector3> writer) {
        return SceneNumbers.place(
                "Sphere " + axis,
                "The place of the sphere's center " + direction + ".",
                scene -> reader.applyAsDouble(position(scene, body)),
                (scene, number) -> moved(scene, body, writer.apply(position(scene, body), number)));
    }

    static Scene edited(Scene scene, int body, UnaryOperator<Sphere> edit) {
        List<Sphere> spheres = new ArrayList<>(scene.spheres());
        spheres.set(BodyNumber.sphere(body), edit.apply(sphere(scene, body)));
        return scene.withSpheres(spheres);
    }
}
