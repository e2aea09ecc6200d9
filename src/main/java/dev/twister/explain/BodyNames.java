package dev.twister.explain;

import dev.twister.kernel.Layout;
import dev.twister.scene.Geometry;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.select.Tag;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * What a scene file calls the bodies of a picture.
 *
 * @param scene as its file has it, with hidden bodies and names
 * @param folder of the scene file, which names of files are relative to
 * @param meshes that the picture shows
 */
public record BodyNames(Scene scene, Path folder, SceneMeshes meshes, FrameInput input) {
    /** Of a body by its number in the picture; empty for the sky. */
    public Optional<BodyName> find(int body) {
        if (body == Layout.NOTHING) {
            return Optional.empty();
        }
        if (body == Layout.PLANE) {
            return Optional.of(
                    new BodyName("plane", 1, "", material(scene.ground().material()), "", ""));
        }
        if (input.isLight(body)) {
            return shown(scene.lights().list(), Light::tag, input.lightIndex(body))
                    .map(this::light);
        }
        int firstMesh = input.bodies().firstMesh();
        return firstMesh == Layout.NO_MESHES || body < firstMesh
                ? Optional.of(sphere(body - Layout.FIRST_SPHERE))
                : mesh(body - firstMesh);
    }

    private BodyName light(int place) {
        return new BodyName(
                "light", place + 1, scene.lights().list().get(place).tag().name(), "", "", "");
    }

    private BodyName sphere(int index) {
        Function<Integer, BodyName> listed = place -> {
            Sphere sphere = scene.spheres().get(place);
            return new BodyName("sphere", place + 1, sphere.tag().name(), material(sphere.material()), "", "");
        };
        long shown = scene.spheres().stream()
                .filter(sphere -> !sphere.tag().hidden())
                .count();
        return shown(scene.spheres(), Sphere::tag, index)
                .map(listed)
                .orElseGet(() -> new BodyName("poured sphere", (int) (index - shown) + 1, "", "", "", ""));
    }

    private Optional<BodyName> mesh(int number) {
        int left = number;
        for (int place = 0; place < scene.meshes().size(); place++) {
            Mesh mesh = scene.meshes().get(place);
            int parts = mesh.tag().hidden() || !meshes.holds(mesh) ? 0 : meshes.parts(mesh);
            if (left < parts) {
                String part = meshes.partName(mesh, left);
                return Optional.of(new BodyName(
                        "mesh",
                        place + 1,
                        mesh.tag().name(),
                        mesh.material().map(this::material).orElse(""),
                        source(mesh.geometry()),
                        parts == 1 ? "" : part.isEmpty() ? left + 1 + " of " + parts : part));
            }
            left -= parts;
        }
        return Optional.empty();
    }

    private String source(Geometry geometry) {
        if (geometry instanceof Geometry.OfFile file) {
            Path path = file.path().toAbsolutePath();
            return path.startsWith(folder) ? folder.relativize(path).toString() : path.toString();
        }
        return geometry.name();
    }

    /** The first name of the material; empty where the body has its own. */
    private String material(Material material) {
        return scene.materials().entrySet().stream()
                .filter(named -> named.getValue().equals(material))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse("");
    }

    /** The place in the list of the body with that index among those that are not hidden. */
    private static <T> Optional<Integer> shown(List<T> list, Function<T, Tag> tag, int index) {
        return IntStream.range(0, list.size())
                .filter(place -> !tag.apply(list.get(place)).hidden())
                .skip(index)
                .boxed()
                .findFirst();
    }

    /**
     * What a scene file says of a body. A text is empty where the file has none.
     *
     * @param kind {@code light}, {@code plane}, {@code sphere}, {@code poured sphere} or {@code mesh}
     * @param number in the scene file's list, from 1
     * @param name of the body or light
     * @param material its name in the scene file
     * @param source the mesh's file as the scene names it, or its shape
     * @param part of a mesh's file that has several: its name, or such as {@code 2 of 3}
     */
    record BodyName(String kind, int number, String name, String material, String source, String part) {
        /** Such as {@code sphere 2, "Ball", material "glass"}. */
        String text() {
            return Stream.of(
                            kind.equals("plane") ? kind : kind + " " + number,
                            quoted("", name),
                            source,
                            part.isEmpty() ? "" : "part " + part,
                            quoted("material ", material))
                    .filter(text -> !text.isEmpty())
                    .collect(Collectors.joining(", "));
        }

        Map<String, Object> tree() {
            Map<String, Object> tree = new LinkedHashMap<>();
            tree.put("kind", kind);
            tree.put("number", number);
            Map<String, String> texts = new LinkedHashMap<>();
            texts.put("name", name);
            texts.put("material", material);
            texts.put("source", source);
            texts.put("part", part);
            texts.forEach((key, text) -> {
                if (!text.isEmpty()) {
                    tree.put(key, text);
                }
            });
            return tree;
        }

        private static String quoted(String before, String name) {
            return name.isEmpty() ? "" : before + '"' + name + '"';
        }
    }
}
