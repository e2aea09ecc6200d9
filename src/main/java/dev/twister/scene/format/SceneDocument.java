package dev.twister.scene.format;

import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.format.json.JsonPath;
import dev.twister.scene.format.json.JsonText;
import dev.twister.scene.format.json.LocatedTree;
import dev.twister.scene.format.json.SourceText;
import java.util.LinkedHashMap;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A scene file's text: reads it and writes it. */
final class SceneDocument {
    private SceneDocument() {}

    /** @throws SceneException if the text is not a valid scene */
    static Scene parse(SourceText source, NamedFiles files) {
        Place root = new Place(source, new JsonPath.Root(), LocatedTree.parse(source));
        Fields fields = root.fields();
        // Before the fields' names, which another version may have changed.
        int version = fields.find(SceneFormat.VERSION_FIELD)
                .map(SceneFormat.VERSION::read)
                .orElse(Scene.VERSION);
        Scene scene = new SceneFormat(version, materials(fields, version, files), files)
                .scene()
                .read(root);
        LightRules.check(fields);
        LightRules.checkVisible(scene, fields);
        LightRules.checkGroups(scene, fields);
        KeyframeRules.check(scene.camera().keyframes(), fields.get("camera").fields());
        ViewRules.check(scene.views(), fields);
        AlphaRules.check(scene, fields);
        GroundRules.check(scene.ground(), fields.get("plane").fields());
        ShapeRules.check(scene.meshes(), fields);
        TrackRules.check(scene, fields);
        scene.pour()
                .ifPresent(pour -> PourRules.check(
                        pour, fields.get("pour").fields(), scene.spheres().size()));
        return scene;
    }

    /**
     * Fields in a fixed order, one line per part, per material and per sphere; of the oldest version that has all that
     * the scene needs.
     *
     * @param schema stands first, where there is one
     */
    static String of(Scene scene, NamedFiles files, Optional<String> schema) {
        int version =
                new SceneFormat(Scene.VERSION, scene.materials(), files).scene().version(scene);
        SceneFormat format = new SceneFormat(version, scene.materials(), files);
        Stream<String> named =
                schema.map(reference -> JsonText.member(SchemaReference.FIELD, JsonText.string(reference))).stream();
        return "{\n  "
                + Stream.concat(named, format.scene().members(scene).stream()).collect(Collectors.joining(",\n  "))
                + "\n}\n";
    }

    // Before the bodies, which name them.
    private static SequencedMap<String, Material> materials(Fields fields, int version, NamedFiles files) {
        SequencedMap<String, Material> none = new LinkedHashMap<>();
        return version < SceneFormat.MATERIALS_SINCE
                ? none
                : fields.find(SceneFormat.MATERIALS)
                        .map(new SceneFormat(version, none, files).materials()::read)
                        .orElse(none);
    }
}
