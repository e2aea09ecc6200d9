package dev.twister.gui.model;

import dev.twister.scene.Scene;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** The bodies that a person can choose from by name. */
public final class BodyList {
    /** Of more spheres or meshes, only the selected one is listed. */
    private static final int MOST = 1000;

    private BodyList() {}

    /** Nothing, the light, the plane, then the spheres and the meshes in the scene's order. */
    public static List<Integer> of(Scene scene, int selected) {
        int spheres = scene.spheres().size();
        int meshes = scene.meshes().size();
        List<Integer> bodies = IntStream.concat(
                        IntStream.range(BodyNumber.NONE, BodyNumber.ofSphere(spheres <= MOST ? spheres : 0)),
                        IntStream.range(0, meshes <= MOST ? meshes : 0).map(BodyNumber::ofMesh))
                .boxed()
                .toList();
        return bodies.contains(selected)
                ? bodies
                : Stream.concat(bodies.stream(), Stream.of(selected)).toList();
    }

    /**
     * Such as {@code Sphere 3, glass} or {@code Mesh 1 (knot.obj), glass}: with the name of its material, where it has
     * one.
     */
    public static String name(Scene scene, int body) {
        if (BodyEdits.isPoured(scene, body)) {
            return "Sphere " + (BodyNumber.sphere(body) + 1) + ", poured";
        }
        return title(scene, body)
                + Optional.of(body)
                        .filter(solid -> BodyEdits.isSolid(scene, solid) && BodyMaterials.has(scene, solid))
                        .map(solid -> BodyMaterials.of(scene, solid))
                        .flatMap(material -> scene.materials().entrySet().stream()
                                .filter(named -> named.getValue().equals(material))
                                .findFirst())
                        .map(named -> ", " + named.getKey())
                        .orElse("");
    }

    /** The name without the material's: {@code Sphere 3} or {@code Mesh 1 (knot.obj)}. */
    public static String title(Scene scene, int body) {
        if (BodyEdits.isMesh(scene, body)) {
            return "Mesh " + (BodyNumber.mesh(body) + 1) + " ("
                    + BodyEdits.mesh(scene, body).file().getFileName() + ")";
        }
        return switch (body) {
            case BodyNumber.NONE -> "Nothing";
            case BodyNumber.LIGHT -> "Light";
            case BodyNumber.PLANE -> "Plane";
            default -> "Sphere " + (BodyNumber.sphere(body) + 1);
        };
    }
}
