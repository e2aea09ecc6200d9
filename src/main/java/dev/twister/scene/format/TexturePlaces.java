package dev.twister.scene.format;

import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.format.json.JsonPath;
import dev.twister.scene.property.MaterialProperties;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.SequencedMap;

/** Which textures a scene has, and where its file first names them. */
public final class TexturePlaces {
    private static final JsonPath ROOT = new JsonPath.Root();

    private final SequencedMap<Path, String> placeByFile = new LinkedHashMap<>();

    private TexturePlaces() {}

    /**
     * The files of the textures, each once, with the place in a scene file that first names it, such as
     * {@code $.materials.earth.texture}.
     */
    public static SequencedMap<Path, String> of(Scene scene) {
        TexturePlaces places = new TexturePlaces();
        JsonPath materials = new JsonPath.Field(ROOT, "materials");
        scene.materials().forEach((name, material) -> places.add(material, new JsonPath.Field(materials, name)));
        places.add(scene.ground().material(), new JsonPath.Field(ROOT, "plane"));
        scene.pour().ifPresent(pour -> places.add(pour.material(), new JsonPath.Field(ROOT, "pour")));
        JsonPath spheres = new JsonPath.Field(ROOT, "spheres");
        for (int i = 0; i < scene.spheres().size(); i++) {
            places.add(scene.spheres().get(i).material(), new JsonPath.Item(spheres, i));
        }
        JsonPath meshes = new JsonPath.Field(ROOT, "meshes");
        for (int i = 0; i < scene.meshes().size(); i++) {
            JsonPath mesh = new JsonPath.Item(meshes, i);
            scene.meshes().get(i).material().ifPresent(material -> places.add(material, mesh));
        }
        return places.placeByFile;
    }

    private void add(Material material, JsonPath body) {
        MaterialProperties.IMAGES.forEach(
                image -> image.getter().apply(material).ifPresent(file -> add(file, body, image.name())));
        material.images().forEach(file -> add(file, body, "texture"));
    }

    private void add(Path file, JsonPath body, String field) {
        placeByFile.putIfAbsent(file, new JsonPath.Field(body, field).toString());
    }
}
