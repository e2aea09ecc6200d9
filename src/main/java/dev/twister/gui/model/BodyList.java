package dev.twister.gui.model;

import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import java.util.List;
import java.util.stream.IntStream;

/** The bodies that a person can choose from by name. */
public final class BodyList {
    /** Of more spheres, only the selected one is listed. */
    private static final int MOST = 1000;

    private BodyList() {}

    /** Nothing, the light, the plane, and the spheres in the scene's order. */
    public static List<Integer> of(Scene scene, int selected) {
        int spheres = scene.spheres().size();
        int last = BodyNumber.ofSphere(spheres <= MOST ? spheres : 0);
        return IntStream.concat(
                        IntStream.range(BodyNumber.NONE, last),
                        selected < last ? IntStream.empty() : IntStream.of(selected))
                .boxed()
                .toList();
    }

    /** Such as {@code Sphere 3, glass}: the name of its material, where it has one. */
    public static String name(Scene scene, int body) {
        return switch (body) {
            case BodyNumber.NONE -> "Nothing";
            case BodyNumber.LIGHT -> "Light";
            case BodyNumber.PLANE -> "Plane";
            default -> sphereName(scene, body);
        };
    }

    private static String sphereName(Scene scene, int body) {
        String number = "Sphere " + (BodyNumber.sphere(body) + 1);
        if (!BodyEdits.isSphere(scene, body)) {
            return BodyEdits.isPoured(scene, body) ? number + ", poured" : number;
        }
        Material material = BodyEdits.sphere(scene, body).material();
        return scene.materials().entrySet().stream()
                .filter(named -> named.getValue().equals(material))
                .findFirst()
                .map(named -> number + ", " + named.getKey())
                .orElse(number);
    }
}
