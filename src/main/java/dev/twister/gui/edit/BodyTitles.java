package dev.twister.gui.edit;

import dev.twister.scene.Scene;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** The bodies that the user can choose by name. */
public final class BodyTitles {
    /** Of more lights, spheres or meshes, only the selected ones are listed, and no more of those. */
    private static final int MOST = 1000;

    private BodyTitles() {}

    /** The lights, the plane, then the spheres and the meshes in the scene's order; last a poured sphere. */
    public static List<Integer> of(Scene scene, SelectedBodies selected) {
        int spheres = scene.spheres().size();
        int meshes = scene.meshes().size();
        return Stream.of(
                        some(scene.lights().count(), BodyNumber::ofLight, selected),
                        Stream.of(BodyNumber.PLANE),
                        some(spheres, BodyNumber::ofSphere, selected),
                        some(meshes, BodyNumber::ofMesh, selected),
                        selected.bodies().stream().filter(body -> BodyEdits.isPoured(scene, body)))
                .flatMap(bodies -> bodies)
                .toList();
    }

    private static Stream<Integer> some(int count, IntFunction<Integer> number, SelectedBodies selected) {
        Stream<Integer> all = IntStream.range(0, count).mapToObj(number);
        return count <= MOST ? all : all.filter(selected::contains).limit(MOST);
    }

    /**
     * The displayed name, with that of the body's material if it has one: {@code Sphere 3, glass} or {@code Mesh 1
     * (knot.obj), glass}.
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

    /**
     * The name without the material's: the one that it was given, or {@code Light 2}, {@code Sphere 3} or {@code Mesh 1
     * (knot.obj)}.
     */
    public static String title(Scene scene, int body) {
        String name = TagEdits.of(scene, body).name();
        if (!name.isEmpty()) {
            return name;
        }
        if (BodyEdits.isMesh(scene, body)) {
            return "Mesh " + (BodyNumber.mesh(body) + 1) + " ("
                    + BodyEdits.mesh(scene, body).geometry().name() + ")";
        }
        if (BodyEdits.isLight(scene, body)) {
            return scene.lights().count() == 1 ? "Light" : "Light " + (BodyNumber.light(body) + 1);
        }
        return switch (body) {
            case BodyNumber.NONE -> "Nothing";
            case BodyNumber.PLANE -> "Plane";
            default -> "Sphere " + (BodyNumber.sphere(body) + 1);
        };
    }
}
