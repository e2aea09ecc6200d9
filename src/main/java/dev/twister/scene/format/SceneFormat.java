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
import dev.twister.scene.Integrator;
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
import dev.twister.scene.ToneMap;
import dev.twister.scene.Track;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.ValueType.Array;
import dev.twister.scene.format.ValueType.Choice;
import dev.twister.scene.format.ValueType.Decimal;
import dev.twister.scene.format.ValueType.FilePath;
import dev.twister.scene.format.ValueType.Flag;
import dev.twister.scene.format.ValueType.GroupName;
import dev.twister.scene.format.ValueType.Lines;
import dev.twister.scene.format.ValueType.Structure;
import dev.twister.scene.format.ValueType.Text;
import dev.twister.scene.format.ValueType.Version;
import dev.twister.scene.format.ValueType.WholeNumber;
import dev.twister.scene.generate.Palette;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneLimits;
import dev.twister.scene.select.Tag;
import dev.twister.scene.select.Title;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.function.BiFunction;
import java.util.function.Function;

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
    private static final ValueType<Rgb> ALBEDO = ValueType.color(SceneLimits.ALBEDO);
    private static final ValueType<Boolean> FLAG = new Flag();
    private static final ValueType<String> REFERENCE = new Text(0, SceneLimits.MAX_PATH_LENGTH);

    private static final Structure<CameraKeyframe> KEYFRAME = new Structure<>(
            CameraKeyframe.DEFAULT,
            List.of(
                    required(
                            KeyframeRules.TIME,
                            new Decimal(SceneLimits.KEYFRAME_TIME),
                            CameraKeyframe::seconds,
                            CameraKeyframe::withSeconds),
                    required("position", POSITION, CameraKeyframe::position, CameraKeyframe::withPosition),
                    required(
                            "yaw",
                            new Decimal(SceneLimits.YAW),
                            CameraKeyframe::yawDegrees,
                            CameraKeyframe::withYawDegrees),
                    required(
                            "pitch",
                            new Decimal(SceneLimits.PITCH),
                            CameraKeyframe::pitchDegrees,
                            CameraKeyframe::withPitchDegrees),
                    optional(
                            "fieldOfView",
                            new Decimal(SceneLimits.FIELD_OF_VIEW),
                            CameraKeyframe::fieldOfViewDegrees,
                            CameraKeyframe::withFieldOfViewDegrees),
                    optional(
                            "focusDistance",
                            new Decimal(SceneLimits.FOCUS_DISTANCE),
                            CameraKeyframe::focusDistance,
                            CameraKeyframe::withFocusDistance)));

    private static final List<Field<Camera, ?>> CAMERA = List.of(
            required("position", POSITION, Camera::position, Camera::withPosition),
            required("yaw", new Decimal(SceneLimits.YAW), Camera::yawDegrees, Camera::withYawDegrees),
            required("pitch", new Decimal(SceneLimits.PITCH), Camera::pitchDegrees, Camera::withPitchDegrees),
            required(
                    "fieldOfView",
                    new Decimal(SceneLimits.FIELD_OF_VIEW),
                    Camera::fieldOfViewDegrees,
                    Camera::withFieldOfViewDegrees),
            sparse("aperture", new Decimal(SceneLimits.APERTURE), Camera::aperture, Camera::withAperture)
                    .from(2),
            sparse(
                            "focusDistance",
                            new Decimal(SceneLimits.FOCUS_DISTANCE),
                            Camera::focusDistance,
                            Camera::withFocusDistance)
                    .from(2));

    private static final Field<Camera, List<CameraKeyframe>> KEYFRAMES = Field.<Camera, List<CameraKeyframe>>sparse(
                    KeyframeRules.FIELD,
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

    private static final List<Field<Light, ?>> LIGHT = List.of(
            required("position", POSITION, Light::position, Light::withPosition),
            required("radius", LENGTH, Light::radius, Light::withRadius),
            required("color", ValueType.color(SceneLimits.RADIANCE), Light::color, Light::withColor),
            optional("strength", new Decimal(SceneLimits.LIGHT_STRENGTH), Light::strength, Light::withStrength)
                    .from(LIGHTS_SINCE),
            sparse("share", new Decimal(SceneLimits.LIGHT_SHARE), Light::share, Light::withShare)
                    .from(LIGHTS_SINCE),
            sparse("lightGroup", new GroupName(), Light::group, Light::withGroup)
                    .from(LIGHTS_SINCE));

    private static final List<Field<Ground, ?>> PLANE = List.of(
            required("size", LENGTH, Ground::size, Ground::withSize),
            required("height", new Decimal(SceneLimits.POSITION), Ground::height, Ground::withHeight));

    private static final Field<Ground, List<Rgb>> PLANE_COLORS = required(
            "colors",
            new Array<>(ALBEDO, 2, 2, "an array of 2 colors"),
            plane -> List.of(plane.evenColor(), plane.oddColor()),
            (plane, colors) -> plane.withColors(colors.getFirst(), colors.getLast()));

    private static final List<Field<Sphere, ?>> SPHERE = List.of(
            required("position", POSITION, Sphere::position, Sphere::withPosition),
            required("radius", LENGTH, Sphere::radius, Sphere::withRadius));

    private static final List<Field<Rendering, ?>> RENDERING = List.of(
            written("width", new WholeNumber(SceneLimits.SIDE), Rendering::width, Rendering::withWidth),
            written("height", new WholeNumber(SceneLimits.SIDE), Rendering::height, Rendering::withHeight),
            written(
                    "shadowSamples",
                    new WholeNumber(SceneLimits.SHADOW_SAMPLES),
                    Rendering::shadowSamples,
                    Rendering::withShadowSamples),
            written("bounces", new WholeNumber(SceneLimits.BOUNCES), Rendering::bounces, Rendering::withBounces),
            written(
                    "samplesPerPixel",
                    new WholeNumber(SceneLimits.SAMPLES_PER_PIXEL),
                    Rendering::samplesPerPixel,
                    Rendering::withSamplesPerPixel),
            written("exposure", new Decimal(SceneLimits.EXPOSURE), Rendering::exposure, Rendering::withExposure),
            written("toneMap", new Choice<>(ToneMap.class), Rendering::toneMap, Rendering::withToneMap),
            written("srgb", FLAG, Rendering::srgb, Rendering::withSrgb),
            sparse("integrator", new Choice<>(Integrator.class), Rendering::integrator, Rendering::withIntegrator)
                    .from(3),
            sparse("clamp", new Decimal(SceneLimits.CLAMP), Rendering::clamp, Rendering::withClamp)
                    .from(3));

    private static final Structure<Physics> PHYSICS = new Structure<>(
            Physics.DEFAULT,
            List.of(
                    written("gravity", ValueType.vector(SceneLimits.GRAVITY), Physics::gravity, Physics::withGravity),
                    written(
                            "elasticity",
                            new Decimal(SceneLimits.ELASTICITY),
                            Physics::elasticity,
                            Physics::withElasticity),
                    written("friction", new Decimal(SceneLimits.FRICTION), Physics::friction, Physics::withFriction),
                    written("damping", new Decimal(SceneLimits.DAMPING), Physics::damping, Physics::withDamping),
                    written("walls", FLAG, Physics::walls, Physics::withWalls),
                    written("solidLight", FLAG, Physics::solidLight, Physics::withSolidLight)));

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

    private static final Structure<Shading> SHADING = new Structure<>(
            Shading.DEFAULT,
            List.of(written(
                    "ambient",
                    new Decimal(SceneLimits.AMBIENT),
                    Shading::ambient,
                    (_, ambient) -> new Shading(ambient))));

    static final Version VERSION = new Version(Scene.VERSION);

    private final int version;
    private final NamedMaterials named;
    private final MaterialFormat material;
    private final MaterialFormat uncolored;
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
        material = MaterialFormat.whole(file);
        uncolored = MaterialFormat.uncolored(file);
    }

    Structure<Camera> camera() {
        return structure(Camera.DEFAULT, List.of(CAMERA, List.of(KEYFRAMES)));
    }

    Structure<CameraView> view() {
        List<Field<CameraView, ?>> camera = CAMERA.stream()
                .<Field<CameraView, ?>>map(field -> field.within(CameraView::camera, CameraView::withCamera))
                .toList();
        return structure(CameraView.DEFAULT, List.of(List.of(VIEW_NAME), camera));
    }

    ValueType<SequencedMap<String, Material>> materials() {
        return new Members<>(
                new Text(1, SceneLimits.MAX_NAME_LENGTH),
                Structure.of(version, Material.DEFAULT, material.fields()),
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
                        List.of(PLANE, List.of(name, oddColor))),
                structure(
                        Ground.DEFAULT,
                        List.of(
                                PLANE,
                                List.of(PLANE_COLORS),
                                uncolored.within(Ground::material, Ground::withMaterial))),
                plane -> named.have(plane.material()));
    }

    Shaped<Sphere> sphere() {
        List<Field<Sphere, ?>> tags = tags(Sphere::tag, Sphere::withTag);
        Field<Sphere, Material> name = required(MATERIAL, named, Sphere::material, Sphere::withMaterial)
                .from(2);
        return new Shaped<>(
                MATERIAL,
                structure(Sphere.DEFAULT, List.of(SPHERE, List.of(name), tags)),
                structure(
                        Sphere.DEFAULT, List.of(SPHERE, material.within(Sphere::material, Sphere::withMaterial), tags)),
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
        List<Field<Mesh, ?>> placement = List.of(
                sparse("position", POSITION, Mesh::position, Mesh::withPosition).from(2),
                sparse("rotation", ValueType.rotation(SceneLimits.ROTATION), Mesh::rotation, Mesh::withRotation)
                        .from(2),
                sparse("scale", new Decimal(SceneLimits.SCALE), Mesh::scale, Mesh::withScale)
                        .from(2));
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
                                uncolored.optional().within(Mesh::own, Mesh::withMaterial),
                                tags)),
                mesh -> mesh.material().filter(named::have).isPresent());
    }

    Structure<Pour> pour() {
        return structure(
                Pour.DEFAULT, List.of(POUR, uncolored.within(Pour::material, Pour::withMaterial), List.of(POUR_SEED)));
    }

    private static <R> List<Field<R, ?>> tags(Function<R, Tag> tag, BiFunction<R, Tag, R> withTag) {
        return TAG.stream()
                .<Field<R, ?>>map(field -> field.within(tag, withTag))
                .toList();
    }

    private <R> Structure<R> structure(R defaults, List<List<Field<R, ?>>> parts) {
        return Structure.of(
                version, defaults, parts.stream().flatMap(List::stream).toList());
    }

    private Field<Lights, Optional<Light>> light() {
        Field<Lights, Optional<Light>> field = required(
                LightRules.ONE,
                ValueType.present(structure(Light.DEFAULT, List.of(LIGHT, tags(Light::tag, Light::withTag)))),
                lights -> Optional.of(lights.first()).filter(_ -> lights.count() == 1),
                (_, light) -> Lights.of(light.orElseThrow()));
        return version < LIGHTS_SINCE ? field : field.orOther();
    }

    private Field<Lights, Optional<List<Light>>> lights() {
        Array<Light> several = new Array<>(
                structure(Light.DEFAULT, List.of(LIGHT, tags(Light::tag, Light::withTag))),
                1,
                SceneLimits.MAX_LIGHTS,
                "an array of 1 to " + SceneLimits.MAX_LIGHTS + " lights");
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
                Scene.under(Path.of("")),
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
                        required("camera", camera(), Scene::camera, Scene::withCamera),
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
                        required("plane", plane(), Scene::ground, Scene::withGround),
                        required(SKYBOX, file, Sky::file, Sky::withFile).within(Scene::sky, Scene::withSky),
                        sparse(
                                        "skyRotation",
                                        new Decimal(SceneLimits.SKY_ROTATION),
                                        Sky::rotationDegrees,
                                        Sky::withRotationDegrees)
                                .within(Scene::sky, Scene::withSky),
                        sparse("skyStrength", new Decimal(SceneLimits.SKY_STRENGTH), Sky::strength, Sky::withStrength)
                                .within(Scene::sky, Scene::withSky),
                        written("shading", SHADING, Scene::shading, Scene::withShading),
                        written(
                                "rendering",
                                structure(Rendering.DEFAULT, List.of(RENDERING)),
                                Scene::rendering,
                                Scene::withRendering),
                        sparse("physics", PHYSICS, Scene::physics, Scene::withPhysics),
                        optional("pour", pour(), Scene::pour, Scene::withPour),
                        required(
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
