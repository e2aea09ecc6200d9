package dev.twister.gui.edit;

import dev.twister.scene.Scene;
import dev.twister.scene.TrackTarget;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** The displayed names of bodies and of what has keyframes. */
public final class BodyTitles {
    /** Of more lights, spheres or meshes, only the selected ones are listed, and no more of those. */
    private static final int MOST = 1000;

    private BodyTitles() {}

    /** The lights, the plane, then the spheres and the meshes in the scene's order; last a poured sphere. */
    public static List<Integer> listed(Scene scene, SelectedBodies selected) {
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
            String kind = property(BodyEdits.light(scene, body).shape().name());
            return scene.lights().count() == 1 ? kind : kind + " " + (BodyNumber.light(body) + 1);
        }
        return switch (body) {
            case BodyNumber.NONE -> "Nothing";
            case BodyNumber.PLANE -> "Plane";
            default -> "Sphere " + (BodyNumber.sphere(body) + 1);
        };
    }

    /** Such as {@code Sphere 3} or {@code Sky}. */
    public static String of(Scene scene, TrackTarget target) {
        return switch (target.kind()) {
            case CAMERA -> "Camera";
            case LIGHT -> title(scene, BodyNumber.ofLight(target.index()));
            case PLANE -> "Plane";
            case SPHERE -> title(scene, BodyNumber.ofSphere(target.index()));
            case MESH -> title(scene, BodyNumber.ofMesh(target.index()));
            case SKY -> "Sky";
            case SHADING -> "Ambient light";
            case RENDERING -> "Picture";
        };
    }

    /** Such as {@code Emission strength}. */
    public static String property(String name) {
        String words = name.replaceAll("([A-Z])", " $1").toLowerCase(Locale.ROOT);
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }

    /** What keyframes of a selected body are of; empty for a poured sphere and for nothing. */
    public static Optional<TrackTarget> target(Scene scene, int body) {
        if (BodyEdits.isLight(scene, body)) {
            return Optional.of(TrackTarget.light(BodyNumber.light(body)));
        }
        if (BodyEdits.isMesh(scene, body)) {
            return Optional.of(TrackTarget.mesh(BodyNumber.mesh(body)));
        }
        if (BodyEdits.isSphere(scene, body)) {
            return Optional.of(TrackTarget.sphere(BodyNumber.sphere(body)));
        }
        return Optional.of(TrackTarget.PLANE).filter(_ -> body == BodyNumber.PLANE);
    }
}
