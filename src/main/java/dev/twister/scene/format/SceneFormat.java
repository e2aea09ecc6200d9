package dev.twister.scene.format;

import static dev.twister.scene.format.Field.optional;
import static dev.twister.scene.format.Field.required;
import static dev.twister.scene.format.Field.sparse;
import static dev.twister.scene.format.Field.written;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.CameraView;
import dev.twister.scene.Easing;
import dev.twister.scene.Ground;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Physics;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Shape;
import dev.twister.scene.Sky;
import dev.twister.scene.Sphere;
import dev.twister.scene.Track;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.ValueType.Array;
import dev.twister.scene.format.ValueType.Choice;
import dev.twister.scene.format.ValueType.Decimal;
import dev.twister.scene.format.ValueType.FilePath;
import dev.twister.scene.format.ValueType.Flag;
import dev.twister.scene.format.ValueType.Lines;
import dev.twister.scene.format.ValueType.Structure;
import dev.twister.scene.format.ValueType.Text;
import dev.twister.scene.format.ValueType.Version;
import dev.twister.scene.format.ValueType.WholeNumber;
import dev.twister.scene.generate.Palette;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Reflectance;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneLimits;
import dev.twister.scene.property.SceneProperties;
import dev.twister.scene.select.Tag;
import dev.twister.scene.select.Title;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The fields of a scene file of some version: the one list that reader and writer go by, and that the schema is held
 * to.
 */
final class SceneFormat {
    static final String VERSION_FIELD = "version";
    static final String MATERIALS = "materials";
    static final String SKYBOX = "skybox";

    /** The version that first has named materials. */
    static final int MATERIALS_SINCE = 2;

    /** The version that first has several lights. */
    private static final int LIGHTS_SINCE = 3;

    /** The version that first has names of bodies. */
    private static final int TAGS_SINCE = 3;

    /** The version that first has tracks. */
    private static final int TRACKS_SINCE = 3;

    private static final String MATERIAL = "material";

    private static final ValueType<Vector3> POSITION = ValueType.vector(SceneLimits.POSITION);
    private static final ValueType<Double> LENGTH = new Decimal(SceneLimits.LENGTH);
    private static final ValueType<Rgb> ALBEDO = ValueType.color(SceneLimits.SHARE);
    private static final ValueType<Boolean> FLAG = new Flag();
    private static final ValueType<String> REFERENCE = new Text(0, SceneLimits.MAX_PATH_LENGTH);

    private static final Structure<CameraKeyframe> KEYFRAME = new Structure<>(
            CameraKeyframe.DEFAULT,
            List.of(
                    required(
                            CameraRules.TIME,
                            new Decimal(SceneLimits.KEYFRAME_TIME),
                            CameraKeyframe::seconds,
                            CameraKeyframe::withSeconds),
                    required("position", POSITION, CameraKeyframe::position, CameraKeyframe::withPosition),
                    required(
                            "yaw",
                            decimal(CameraProperties.YAW),
                            CameraKeyframe::yawDegrees,
                            CameraKeyframe::withYawDegrees),
                    required(
                            "pitch",
                            decimal(CameraProperties.PITCH),
                            CameraKeyframe::pitchDegrees,
                            CameraKeyframe::withPitchDegrees),
                    optional(
                            "fieldOfView",
                            decimal(CameraProperties.FIELD_OF_VIEW),
                            CameraKeyframe::fieldOfViewDegrees,
                            CameraKeyframe::withFieldOfViewDegrees),
                    optional(
                            "focusDistance",
                            decimal(CameraProperties.FOCUS_DISTANCE),
                            CameraKeyframe::focusDistance,
                            CameraKeyframe::withFocusDistance)));

    private static final Field<Camera, List<CameraKeyframe>> KEYFRAMES = Field.<Camera, List<CameraKeyframe>>sparse(
                    CameraRules.KEYFRAMES,
                    new Array<>(
                            KEYFRAME,
                            0,
                            SceneLimits.MAX_KEYFRAMES,
                            "an array of 0 to " + SceneLimits.MAX_KEYFRAMES + " keyframes"),
                    Camera::keyframes,
                    Camera::withKeyframes)
            .from(2);

    private static final Structure<Keyframe> TRACK_KEYFRAME = new Structure<>(
            Keyframe.DEFAULT,
            List.of(
                    required(
                            TrackRules.TIME,
                            new Decimal(SceneLimits.KEYFRAME_TIME),
                            Keyframe::seconds,
                            Keyframe::withSeconds),
                    required(
                            TrackRules.VALUE,
                            new NumberOrVector(
                                    new Decimal(SceneLimits.ANIMATED),
                                    new Array<>(
                                            new Decimal(SceneLimits.ANIMATED),
                                            3,
                                            3,
                                            "a number or an array of 3 numbers")),
                            Keyframe::value,
                            Keyframe::withValue),
                    sparse("easing", new Choice<>(Easing.class), Keyframe::easing, Keyframe::withEasing)));

    private static final Structure<Track> TRACK = new Structure<>(
            Track.DEFAULT,
            List.of(
                    required(TrackRules.TARGET, new TrackTargetType(), Track::target, Track::withTarget),
                    required(
                            TrackRules.PROPERTY,
                            new Text(1, SceneLimits.MAX_NAME_LENGTH),
                            Track::property,
                            Track::withProperty),
                    sparse("loop", FLAG, Track::loop, Track::withLoop),
                    required(
                            TrackRules.KEYFRAMES,
                            new Array<>(
                                    TRACK_KEYFRAME,
                                    1,
                                    SceneLimits.MAX_KEYFRAMES,
                                    "an array of 1 to " + SceneLimits.MAX_KEYFRAMES + " keyframes"),
                            Track::keyframes,
                            Track::withKeyframes)));

    private static final Field<CameraView, String> VIEW_NAME =
            required(ViewRules.NAME, new Text(1, SceneLimits.MAX_NAME_LENGTH), CameraView::name, CameraView::withName);

    private static final List<Field<Tag, ?>> TAG = List.of(
            sparse("name", new Text(0, SceneLimits.MAX_NAME_LENGTH), Tag::name, Tag::withName)
                    .from(TAGS_SINCE),
            sparse("group", new Text(0, SceneLimits.MAX_NAME_LENGTH), Tag::group, Tag::withGroup)
                    .from(TAGS_SINCE),
            sparse("hidden", FLAG, Tag::hidden, Tag::withHidden).from(TAGS_SINCE),
            sparse("locked", FLAG, Tag::locked, Tag::withLocked).from(TAGS_SINCE));

    private static final Field<Ground, List<Rgb>> PLANE_COLORS = required(
            "colors",
            new Array<>(ALBEDO, 2, 2, "an array of 2 colors"),
            plane -> List.of(plane.evenColor(), plane.oddColor()),
            (plane, colors) -> plane.withColors(colors.getFirst(), colors.getLast()));

    private static final List<Field<Pour, ?>> POUR = List.of(
            required(
                    "count",
                    new WholeNumber(new Range(1, SceneLimits.MAX_SPHERES, "spheres")),
                    Pour::count,
                    Pour::withCount),
            required("rate", new Decimal(SceneLimits.POUR_RATE), Pour::rate, Pour::withRate),
            required("position", POSITION, Pour::position, Pour::withPosition),
            required("width", LENGTH, Pour::width, Pour::withWidth),
            required("speed", new Decimal(SceneLimits.POUR_SPEED), Pour::speed, Pour::withSpeed),
            required(
                    "radius",
                    new Array<>(LENGTH, 2, 2, "an array of 2 numbers [least, most]"),
                    pour -> List.of(pour.minRadius(), pour.maxRadius()),
                    (pour, radii) -> pour.withRadii(radii.getFirst(), radii.getLast())),
            required("palette", new Choice<>(Palette.class), Pour::palette, Pour::withPalette));

    private static final Field<Pour, Integer> POUR_SEED =
            required("seed", new WholeNumber(SceneLimits.SEED), Pour::seed, Pour::withSeed);

    static final Version VERSION = new Version(Scene.VERSION);

    private final int version;
    private final NamedMaterials named;
    private final List<Field<Material, ?>> material;
    private final List<Field<Material, ?>> uncolored;
    private final FilePath file;

    /**
     * The format of a file.
     *
     * @param materials those that the file's bodies may name
     * @param files how files' paths are read and written
     */
    SceneFormat(int version, SequencedMap<String, Material> materials, NamedFiles files) {
        this.version = version;
        named = NamedMaterials.of(materials);
        file = new FilePath(new Text(1, SceneLimits.MAX_PATH_LENGTH), files);
        material = materialFields(version, files);
        uncolored = material.subList(1, material.size());
    }

    Structure<Camera> camera() {
        return structure(Camera.USUAL, List.of(fields(CameraProperties.ALL), List.of(KEYFRAMES)));
    }

    Structure<CameraView> view() {
        return structure(
                CameraView.DEFAULT,
                List.of(
                        List.of(VIEW_NAME),
                        within(fields(CameraProperties.ALL), CameraView::camera, CameraView::withCamera)));
    }

    ValueType<SequencedMap<String, Material>> materials() {
        return new Members<>(
                new Text(1, SceneLimits.MAX_NAME_LENGTH),
                Structure.of(version, Material.DEFAULT, material),
                SceneLimits.MAX_MATERIALS);
    }

    /** With a named material, whose color is the even checks', the odd ones have it too unless another is given. */
    Shaped<Ground> plane() {
        Field<Ground, Material> name = required(
                        MATERIAL,
                        named,
                        Ground::material,
                        (plane, material) -> plane.withMaterial(material).withOddColor(material.color()))
                .from(2);
        Field<Ground, Optional<Rgb>> oddColor = optional(
                        "oddColor",
                        ALBEDO,
                        plane -> Optional.of(plane.oddColor()).filter(color -> !color.equals(plane.evenColor())),
                        Ground::withOddColor)
                .from(2);
        return new Shaped<>(
                MATERIAL,
                structure(
                        Ground.DEFAULT.withOddColor(Ground.DEFAULT.evenColor()),
                        List.of(fields(BodyProperties.PLANE), List.of(name, oddColor))),
                structure(
                        Ground.DEFAULT,
                        List.of(
                                fields(BodyProperties.PLANE),
                                List.of(PLANE_COLORS),
                                within(uncolored, Ground::material, Ground::withMaterial))),
                plane -> named.have(plane.material()));
    }

    Shaped<Sphere> sphere() {
        List<Field<Sphere, ?>> tags = tags(Sphere::tag, Sphere::withTag);
        Field<Sphere, Material> name = required(MATERIAL, named, Sphere::material, Sphere::withMaterial)
                .from(2);
        return new Shaped<>(
                MATERIAL,
                structure(Sphere.DEFAULT, List.of(placed(), List.of(name), tags)),
                structure(
                        Sphere.DEFAULT,
                        List.of(placed(), within(material, Sphere::material, Sphere::withMaterial), tags)),
                sphere -> named.have(sphere.material()));
    }

    /** With neither a named material nor fields of one, it is made of what its file says. */
    Shaped<Mesh> mesh() {
        return new Shaped<>(
                MeshFields.SHAPE,
                mesh(Mesh.of(MeshFields.DEFAULT), MeshFields.ofShape(), List.of()),
                mesh(Mesh.DEFAULT, MeshFields.ofFile(file), MeshFields.shading()),
                mesh -> mesh.geometry() instanceof Shape);
    }

    /**
     * @param triangles the fields that say what its triangles are
     * @param shading those that say how they are shaded
     */
    private Shaped<Mesh> mesh(Mesh defaults, List<Field<Mesh, ?>> triangles, List<Field<Mesh, ?>> shading) {
        List<Field<Mesh, ?>> placement = fields(BodyProperties.MESH);
        List<Field<Mesh, ?>> tags = tags(Mesh::tag, Mesh::withTag);
        Field<Mesh, Material> name = Field.<Mesh, Material>required(
                        MATERIAL, named, mesh -> mesh.material().orElseThrow(), Mesh::withMaterial)
                .from(2);
        Field<Mesh, Optional<Rgb>> color = Field.<Mesh, Rgb>optional(
                        "color",
                        ALBEDO,
                        mesh -> mesh.material().map(Material::color),
                        (mesh, given) -> mesh.withMaterial(mesh.own().withColor(given)))
                .from(2);
        return new Shaped<>(
                MATERIAL,
                structure(defaults, List.of(triangles, placement, shading, List.of(name), tags)),
                structure(
                        defaults,
                        List.of(
                                triangles,
                                placement,
                                shading,
                                List.of(color),
                                within(
                                        uncolored.stream()
                                                .<Field<Material, ?>>map(Field::orDefault)
                                                .toList(),
                                        Mesh::own,
                                        Mesh::withMaterial),
                                tags)),
                mesh -> mesh.material().filter(named::have).isPresent());
    }

    Structure<Pour> pour() {
        return structure(
                Pour.DEFAULT.withMaterial(Material.DEFAULT),
                List.of(POUR, within(uncolored, Pour::material, Pour::withMaterial), List.of(POUR_SEED)));
    }

    @SuppressWarnings("unchecked") // the metallic part is a number
    private static List<Field<Material, ?>> materialFields(int version, NamedFiles files) {
        boolean tints = version < ReflectivityType.METALS_SINCE;
        Field<Material, Boolean> tinted = sparse(
                        "tinted",
                        FLAG,
                        (Material material) -> material.reflectance() == Reflectance.TINTED,
                        (material, tint) -> tint && material.reflectivity() > 0 && material.metallic() > 0
                                ? material.withReflectance(Reflectance.TINTED)
                                : material)
                .impliedBefore(ReflectivityType.METALS_SINCE)
                .meaning("whether `metallic` only tints what `reflectivity` mirrors, as in files of version 3 and"
                        + " older");
        Stream<Field<Material, ?>> fields = Field.of(MaterialProperties.ALL, files).stream()
                .map(field -> switch (field.name()) {
                    case "reflectivity" -> ReflectivityType.field(version);
                    case "metallic" -> tints ? ReflectivityType.tint((Field<Material, Double>) field) : field;
                    default -> field;
                });
        return Stream.concat(fields, Stream.of(tinted)).toList();
    }

    private static <R> List<Field<R, ?>> tags(Function<R, Tag> tag, BiFunction<R, Tag, R> withTag) {
        return within(TAG, tag, withTag);
    }

    private static <S, R> List<Field<S, ?>> within(
            List<Field<R, ?>> fields, Function<S, R> part, BiFunction<S, R, S> withPart) {
        return fields.stream()
                .<Field<S, ?>>map(field -> field.within(part, withPart))
                .toList();
    }

    /** The fields of properties none of which is a file. */
    private static <R> List<Field<R, ?>> fields(List<Property<R, ?>> properties) {
        return Field.of(properties, NamedFiles.UNRESOLVED);
    }

    /** A sphere without a place or a size is a mistake. */
    private static List<Field<Sphere, ?>> placed() {
        return fields(BodyProperties.SPHERE).stream()
                .<Field<Sphere, ?>>map(Field::inEveryFile)
                .toList();
    }

    private static ValueType<Double> decimal(Property<Camera, Double> property) {
        return ValueType.of(property.type(), NamedFiles.UNRESOLVED);
    }

    /** Without a type it is a sphere. */
    private Shaped<Light> oneLight() {
        List<Field<Light, ?>> tags = tags(Light::tag, Light::withTag);
        List<Field<Light, ?>> typed = fields(LightProperties.ALL).stream()
                .<Field<Light, ?>>map(field -> switch (field.name()) {
                    case LightRules.TYPE -> field.inEveryFile();
                    case LightRules.DIRECTION -> field.inEachWritten();
                    default -> field.orDefault();
                })
                .toList();
        List<Field<Light, ?>> ofSphere = fields(LightProperties.ALL).stream()
                .filter(field -> !field.name().equals(LightRules.TYPE)
                        && LightProperties.has(LightShape.Kind.SPHERE, field.name()))
                .toList();
        return new Shaped<>(
                LightRules.TYPE,
                structure(Light.DEFAULT, List.of(typed, tags)),
                structure(Light.DEFAULT, List.of(ofSphere, tags)),
                light -> light.shape().kind() != LightShape.Kind.SPHERE);
    }

    private <R> Structure<R> structure(R defaults, List<List<Field<R, ?>>> parts) {
        return Structure.of(
                version, defaults, parts.stream().flatMap(List::stream).toList());
    }

    private Field<Lights, Optional<Light>> light() {
        Field<Lights, Optional<Light>> field = written(
                LightRules.ONE,
                ValueType.present(oneLight()),
                lights -> Optional.of(lights.first()).filter(_ -> lights.count() == 1),
                (_, light) -> Lights.of(light.orElseThrow()));
        return version < LIGHTS_SINCE ? field : field.orOther();
    }

    private Field<Lights, Optional<List<Light>>> lights() {
        Array<Light> several = new Array<>(
                oneLight(), 1, SceneLimits.MAX_LIGHTS, "an array of 1 to " + SceneLimits.MAX_LIGHTS + " lights");
        return Field.<Lights, Optional<List<Light>>>required(
                        LightRules.SEVERAL,
                        ValueType.present(new Lines<>(several)),
                        lights -> Optional.of(lights.list()).filter(_ -> lights.count() > 1),
                        (_, lights) -> new Lights(lights.orElseThrow()))
                .from(LIGHTS_SINCE)
                .orOther();
    }

    Structure<Scene> scene() {
        return Structure.of(
                version,
                Scene.under(Sky.PLAIN).withCamera(Camera.USUAL),
                List.of(
                        // For editors.
                        sparse(SchemaReference.FIELD, REFERENCE, _ -> "", (scene, _) -> scene),
                        required(VERSION_FIELD, VERSION, _ -> version, (scene, _) -> scene),
                        written("name", new Text(0, SceneLimits.MAX_NAME_LENGTH), Title::name, Title::withName)
                                .within(Scene::title, Scene::withTitle),
                        written(
                                        "description",
                                        new Text(0, SceneLimits.MAX_DESCRIPTION_LENGTH),
                                        Title::description,
                                        Title::withDescription)
                                .within(Scene::title, Scene::withTitle),
                        written("camera", camera(), Scene::camera, Scene::withCamera),
                        sparse(
                                        ViewRules.FIELD,
                                        new Lines<>(new Array<>(
                                                view(),
                                                0,
                                                SceneLimits.MAX_VIEWS,
                                                "an array of 0 to " + SceneLimits.MAX_VIEWS + " views")),
                                        Scene::views,
                                        Scene::withViews)
                                .from(2),
                        light().within(Scene::lights, Scene::withLights),
                        lights().within(Scene::lights, Scene::withLights),
                        sparse(MATERIALS, materials(), Scene::materials, Scene::withMaterials)
                                .from(MATERIALS_SINCE),
                        written("plane", plane(), Scene::ground, Scene::withGround),
                        sparse(SKYBOX, file, Sky::file, Sky::withFile).within(Scene::sky, Scene::withSky),
                        Field.of(SceneProperties.SKY_ROTATION, NamedFiles.UNRESOLVED)
                                .named("skyRotation")
                                .within(Scene::sky, Scene::withSky),
                        Field.of(SceneProperties.SKY_STRENGTH, NamedFiles.UNRESOLVED)
                                .named("skyStrength")
                                .within(Scene::sky, Scene::withSky),
                        written(
                                "shading",
                                structure(Shading.DEFAULT, List.of(fields(SceneProperties.SHADING))),
                                Scene::shading,
                                Scene::withShading),
                        written(
                                "rendering",
                                structure(Rendering.DEFAULT, List.of(fields(SceneProperties.RENDERING))),
                                Scene::rendering,
                                Scene::withRendering),
                        sparse(
                                "physics",
                                structure(Physics.DEFAULT, List.of(fields(SceneProperties.PHYSICS))),
                                Scene::physics,
                                Scene::withPhysics),
                        optional("pour", pour(), Scene::pour, Scene::withPour),
                        written(
                                "spheres",
                                new Lines<>(new Array<>(
                                        sphere(),
                                        0,
                                        SceneLimits.MAX_SPHERES,
                                        "an array of 0 to " + SceneLimits.MAX_SPHERES + " spheres")),
                                Scene::spheres,
                                Scene::withSpheres),
                        sparse(
                                        ShapeRules.MESHES,
                                        new Lines<>(new Array<>(
                                                mesh(),
                                                0,
                                                SceneLimits.MAX_MESHES,
                                                "an array of 0 to " + SceneLimits.MAX_MESHES + " meshes")),
                                        Scene::meshes,
                                        Scene::withMeshes)
                                .from(2),
                        sparse(
                                        TrackRules.FIELD,
                                        new Lines<>(new Array<>(
                                                TRACK,
                                                0,
                                                SceneLimits.MAX_TRACKS,
                                                "an array of 0 to " + SceneLimits.MAX_TRACKS + " tracks")),
                                        Scene::tracks,
                                        Scene::withTracks)
                                .from(TRACKS_SINCE)));
    }
}
