package dev.twister.scene;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;

/** Builds a scene from a file's text. */
final class SceneDocument {
    private static final List<String> REQUIRED = List.of("version", "camera", "light", "plane", "spheres", "skybox");
    private static final List<String> OPTIONAL =
            List.of("$schema", "name", "description", "shading", "rendering", "physics", "pour");

    /** Finds the skybox's file by what the scene calls it, and throws the place's failure if it will not do. */
    interface SkyboxFinder {
        Path find(Place place, String name);
    }

    private SceneDocument() {}

    /**
     * @throws SceneException if the text is not a valid scene
     */
    static Scene parse(SourceText source, SkyboxFinder skyboxes) {
        Place root = new Place(source, new JsonPath.Root(), LocatedTree.parse(source));
        Fields fields = root.fields();
        // Before the fields' names, which another version may have changed.
        fields.find("version").ifPresent(SceneDocument::checkVersion);
        fields.check(REQUIRED, OPTIONAL);
        fields.find("$schema").ifPresent(place -> place.text(0, SceneLimits.MAX_PATH_LENGTH));
        List<Sphere> spheres = SceneParts.spheres(fields.get("spheres"));
        return new Scene(
                text(fields, "name", SceneLimits.MAX_NAME_LENGTH),
                text(fields, "description", SceneLimits.MAX_DESCRIPTION_LENGTH),
                SceneParts.camera(fields.get("camera")),
                SceneParts.light(fields.get("light")),
                SceneParts.plane(fields.get("plane")),
                spheres,
                skybox(fields.get("skybox"), skyboxes),
                fields.find("shading").map(SceneDocument::ambient).orElse(Scene.DEFAULT_AMBIENT),
                fields.find("rendering").map(SceneParts::settings).orElse(RenderSettings.DEFAULT),
                fields.find("physics").map(MotionParts::physics).orElse(Physics.DEFAULT),
                fields.find("pour").map(place -> MotionParts.pour(place, spheres.size())));
    }

    private static void checkVersion(Place place) {
        if (!(place.value() instanceof LocatedValue.NumberValue found) || found.number() != Scene.VERSION) {
            throw place.refused(Scene.VERSION + ", the version of the format that this program reads");
        }
    }

    private static String text(Fields fields, String name, int maxLength) {
        return fields.find(name).map(place -> place.text(0, maxLength)).orElse("");
    }

    private static double ambient(Place place) {
        return place.fields()
                .check(List.of(), List.of("ambient"))
                .find("ambient")
                .map(ambient -> ambient.number(SceneLimits.AMBIENT))
                .orElse(Scene.DEFAULT_AMBIENT);
    }

    private static Path skybox(Place place, SkyboxFinder skyboxes) {
        String name = place.text(1, SceneLimits.MAX_PATH_LENGTH);
        try {
            return skyboxes.find(place, name);
        } catch (InvalidPathException e) {
            throw place.refused("a file's path, relative to the scene file's folder");
        }
    }
}
