package dev.twister.scene.format;

import dev.twister.scene.Ground;
import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Sky;
import dev.twister.scene.format.json.JsonPath;
import dev.twister.scene.format.json.JsonText;
import dev.twister.scene.format.json.LocatedTree;
import dev.twister.scene.format.json.LocatedValue.ObjectValue;
import dev.twister.scene.format.json.SourceText;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.material.Alpha;
import dev.twister.scene.property.SceneLimits;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.LinkedHashMap;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.function.Function;
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
        Problems problems = new Problems();
        Optional<SequencedMap<String, Material>> materials = problems.read(() -> materials(fields, version, files));
        Optional<Scene> read =
                problems.read(() -> new SceneFormat(version, materials.orElseGet(() -> namesOf(fields)), files)
                        .scene()
                        .read(root));
        problems.refuse();
        Scene scene = read.map(found ->
                        version < ReflectivityType.METALS_SINCE ? ReflectivityType.tintedByTracks(found) : found)
                .orElseThrow();
        problems.check(() -> LightRules.check(fields));
        problems.check(() -> LightRules.checkShapes(scene, fields));
        problems.check(() -> LightRules.checkVisible(scene, fields));
        problems.check(() -> LightRules.checkGroups(scene, fields));
        fields.find("camera")
                .ifPresent(camera -> problems.check(() -> CameraRules.check(scene.camera(), camera.fields())));
        problems.check(() -> ViewRules.check(scene.views(), fields));
        problems.check(() -> AlphaRules.check(scene, fields));
        fields.find("plane")
                .ifPresent(plane -> problems.check(() -> GroundRules.check(scene.ground(), plane.fields())));
        problems.check(() -> ShapeRules.check(scene.meshes(), fields));
        problems.check(() -> TrackRules.check(scene, fields));
        scene.pour()
                .ifPresent(pour -> problems.check(() -> PourRules.check(
                        pour, fields.get("pour").fields(), scene.spheres().size())));
        problems.refuse();
        return scene;
    }

    /**
     * Fields in a fixed order, one line per part, per material and per sphere; of the oldest version that has all that
     * the scene needs.
     *
     * @param schema stands first, where there is one
     */
    static String of(Scene scene, NamedFiles files, Optional<String> schema) {
        int needed =
                new SceneFormat(Scene.VERSION, scene.materials(), files).scene().version(scene);
        // Older versions have no scene without a panorama.
        int version = scene.sky().file().equals(Sky.PLAIN) ? Scene.VERSION : needed;
        SceneFormat format = new SceneFormat(version, scene.materials(), files);
        Stream<String> named =
                schema.map(reference -> JsonText.member(SchemaReference.FIELD, JsonText.string(reference))).stream();
        return "{\n  "
                + Stream.concat(named, format.scene().members(scene).stream()).collect(Collectors.joining(",\n  "))
                + "\n}\n";
    }

    /** The names of materials some of which cannot be read, so that bodies may name them. */
    private static SequencedMap<String, Material> namesOf(Fields fields) {
        SequencedMap<String, Material> named = new LinkedHashMap<>();
        fields.find(SceneFormat.MATERIALS)
                .filter(place -> place.value() instanceof ObjectValue)
                .ifPresent(place ->
                        place.fields().members().forEach(member -> named.put(member.name(), Material.DEFAULT)));
        return named;
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

    /** Which bodies may be other than opaque: meshes alone. */
    private static final class AlphaRules {
        private AlphaRules() {}

        /**
         * @param fields the scene's, in the file
         * @throws SceneException if the plane or a sphere is not opaque
         */
        static void check(Scene scene, Fields fields) {
            fields.find("plane").ifPresent(plane -> check(scene.ground().material(), plane));
            fields.find("pour").ifPresent(place -> scene.pour().ifPresent(pour -> check(pour.material(), place)));
            fields.find("spheres").ifPresent(spheres -> {
                for (int i = 0; i < scene.spheres().size(); i++) {
                    Material material = scene.spheres().get(i).material();
                    if (!isOpaque(material)) {
                        check(
                                material,
                                spheres.items(0, scene.spheres().size(), "", Function.identity())
                                        .get(i));
                    }
                }
            });
        }

        private static void check(Material material, Place body) {
            if (!isOpaque(material)) {
                Optional<Place> own = body.fields().find("alphaMode");
                throw own.isPresent()
                        ? own.get().failure("is given, but only meshes can be cut out or blended; take a shape")
                        : body.fields()
                                .get("material")
                                .failure("is a material that is not opaque, but only meshes can be; take a shape");
            }
        }

        private static boolean isOpaque(Material material) {
            return material.alpha().mode() == Alpha.Mode.OPAQUE;
        }
    }

    /** What the plane has to be. */
    private static final class GroundRules {
        private GroundRules() {}

        /**
         * @param plane its fields, in the file
         * @throws SceneException if it emits light
         */
        static void check(Ground ground, Fields plane) {
            if (!ground.material().emission().isNone()) {
                Optional<Place> own = plane.find("emission");
                throw own.isPresent()
                        ? own.get().failure("is given, but the plane cannot emit light; add a quad that does")
                        : plane.get("material")
                                .failure(
                                        "is a material that emits, but the plane cannot emit light; add a quad that does");
            }
        }
    }

    /** What the fields of a pour have to be to each other, and to the spheres beside it. */
    private static final class PourRules {
        private static final int SHOWN_DIGITS = 4;

        private PourRules() {}

        /**
         * @param fields the pour's, in the file
         * @param placed how many spheres are there from the start: all together have a limit
         * @throws SceneException if a rule is broken
         */
        static void check(Pour pour, Fields fields, int placed) {
            if (pour.minRadius() > pour.maxRadius()) {
                throw fields.get("radius")
                        .refused("an array of 2 numbers [least, most], the first not above the second");
            }
            if (pour.count() > SceneLimits.MAX_SPHERES - placed) {
                throw fields.get("count")
                        .refused("at most " + (SceneLimits.MAX_SPHERES - placed) + ", which the " + placed
                                + " spheres of the scene leave of " + SceneLimits.MAX_SPHERES);
            }
            if (pour.rate() > pour.maxRate()) {
                throw fields.get("rate")
                        .refused("at most " + rounded(pour.maxRate())
                                + " for spheres of that radius, speed and width of the spout");
            }
        }

        // Down, so that the number in the message is allowed.
        private static String rounded(double number) {
            return BigDecimal.valueOf(number)
                    .round(new MathContext(SHOWN_DIGITS, RoundingMode.DOWN))
                    .toPlainString();
        }
    }
}
