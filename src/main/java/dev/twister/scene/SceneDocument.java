package dev.twister.scene;

import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A scene file's text: reads it and writes it, with the skybox's path as it stands there. */
final class SceneDocument {
    /** Finds the skybox's file by what the scene calls it, and throws the place's failure if it will not do. */
    interface SkyboxFinder {
        Path find(Place place, Path name);
    }

    private SceneDocument() {}

    /**
     * @throws SceneException if the text is not a valid scene
     */
    static Scene parse(SourceText source, SkyboxFinder skyboxes) {
        Place root = new Place(source, new JsonPath.Root(), LocatedTree.parse(source));
        Fields fields = root.fields();
        // Before the fields' names, which another version may have changed.
        fields.find(SceneFormat.VERSION.name()).ifPresent(SceneFormat.VERSION.type()::read);
        Scene scene = SceneFormat.SCENE.read(root);
        scene.pour()
                .ifPresent(pour -> PourRules.check(
                        pour, fields.get("pour").fields(), scene.spheres().size()));
        return scene.withSkybox(skyboxes.find(fields.get("skybox"), scene.skybox()));
    }

    /** Fields in a fixed order, one line per part and one line per sphere; first, where there is one, the schema. */
    static String of(Scene scene, Optional<String> schema) {
        Stream<String> named =
                schema.map(reference -> JsonText.member(SchemaReference.FIELD, JsonText.string(reference))).stream();
        return "{\n  "
                + Stream.concat(named, SceneFormat.SCENE.members(scene).stream())
                        .collect(Collectors.joining(",\n  "))
                + "\n}\n";
    }
}
