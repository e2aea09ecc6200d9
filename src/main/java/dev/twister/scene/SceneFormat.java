package dev.twister.scene;

import static dev.twister.scene.Field.required;
import static dev.twister.scene.Field.sparse;
import static dev.twister.scene.Field.written;

import dev.twister.scene.ValueType.Array;
import dev.twister.scene.ValueType.Choice;
import dev.twister.scene.ValueType.Decimal;
import dev.twister.scene.ValueType.FilePath;
import dev.twister.scene.ValueType.Flag;
import dev.twister.scene.ValueType.Lines;
import dev.twister.scene.ValueType.Structure;
import dev.twister.scene.ValueType.Text;
import dev.twister.scene.ValueType.Version;
import dev.twister.scene.ValueType.WholeNumber;
import java.nio.file.Path;
import java.util.List;

/** The fields of a scene file: the one list that reader and writer go by, and that the schema is held to. */
final class SceneFormat {
    private static final ValueType<Vector3> POSITION = ValueType.vector(SceneLimits.POSITION);
    private static final ValueType<Double> LENGTH = new Decimal(SceneLimits.LENGTH);
    private static final ValueType<Rgb> ALBEDO = ValueType.color(SceneLimits.ALBEDO);
    private static final ValueType<Double> REFLECTIVITY = new Decimal(SceneLimits.REFLECTIVITY);
    private static final ValueType<Boolean> FLAG = new Flag();
    private static final ValueType<String> REFERENCE = new Text(0, SceneLimits.MAX_PATH_LENGTH);

    static final Structure<Camera> CAMERA = new Structure<>(
            Camera.DEFAULT,
            List.of(
                    required("position", POSITION, Camera::position, Camera::withPosition),
                    required("yaw", new Decimal(SceneLimits.YAW), Camera::yawDegrees, Camera::withYaw),
                    required("pitch", new Decimal(SceneLimits.PITCH), Camera::pitchDegrees, Camera::withPitch),
                    required(
                            "fieldOfView",
                            new Decimal(SceneLimits.FIELD_OF_VIEW),
                            Camera::fieldOfViewDegrees,
                            Camera::withFieldOfView)));

    static final Structure<Light> LIGHT = new Structure<>(
            Light.DEFAULT,
            List.of(
                    required("position", POSITION, Light::position, Light::withPosition),
                    required("radius", LENGTH, Light::radius, Light::withRadius),
                    required("color", ValueType.color(SceneLimits.RADIANCE), Light::color, Light::withColor)));

    static final Structure<Plane> PLANE = new Structure<>(
            Plane.DEFAULT,
            List.of(
                    required("size", LENGTH, Plane::size, Plane::withSize),
                    required("height", new Decimal(SceneLimits.POSITION), Plane::height, Plane::withHeight),
                    required(
                            "colors",
                            new Array<>(ALBEDO, 2, 2, "an array of 2 colors"),
                            plane -> List.of(plane.evenColor(), plane.oddColor()),
                            (plane, colors) -> plane.withColors(colors.getFirst(), colors.getLast())),
                    required("reflectivity", REFLECTIVITY, Plane::reflectivity, Plane::withReflectivity)));

    static final Structure<Sphere> SPHERE = new Structure<>(
            Sphere.DEFAULT,
            List.of(
                    required("position", POSITION, Sphere::position, Sphere::withPosition),
                    required("radius", LENGTH, Sphere::radius, Sphere::withRadius),
                    required("color", ALBEDO, Sphere::color, Sphere::withColor),
                    required("reflectivity", REFLECTIVITY, Sphere::reflectivity, Sphere::withReflectivity)));

    static final Structure<RenderSettings> RENDERING = new Structure<>(
            RenderSettings.DEFAULT,
            List.of(
                    written(
                            "width",
                            new WholeNumber(SceneLimits.SIDE),
                            RenderSettings::width,
                            RenderSettings::withWidth),
                    written(
                            "height",
                            new WholeNumber(SceneLimits.SIDE),
                            RenderSettings::height,
                            RenderSettings::withHeight),
                    written(
                            "shadowSamples",
                            new WholeNumber(SceneLimits.SHADOW_SAMPLES),
                            RenderSettings::shadowSamples,
                            RenderSettings::withShadows),
                    written(
                            "bounces",
                            new WholeNumber(SceneLimits.BOUNCES),
                            RenderSettings::bounces,
                            RenderSettings::withBounces),
                    written(
                            "samplesPerPixel",
                            new WholeNumber(SceneLimits.SAMPLES_PER_PIXEL),
                            RenderSettings::samplesPerPixel,
                            RenderSettings::withSamplesPerPixel),
                    written(
                            "exposure",
                            new Decimal(SceneLimits.EXPOSURE),
                            RenderSettings::exposure,
                            RenderSettings::withExposure),
                    written(
                            "toneMap",
                            new Choice<>(ToneMap.class),
                            RenderSettings::toneMap,
                            RenderSettings::withToneMap),
                    written("srgb", FLAG, RenderSettings::srgb, RenderSettings::withSrgb)));

    static final Structure<Physics> PHYSICS = new Structure<>(
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

    static final Structure<Pour> POUR = new Structure<>(
            Pour.DEFAULT,
            List.of(
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
                    required("palette", new Choice<>(Palette.class), Pour::palette, Pour::withPalette),
                    required("reflectivity", REFLECTIVITY, Pour::reflectivity, Pour::withReflectivity),
                    required("seed", new WholeNumber(SceneLimits.SEED), Pour::seed, Pour::withSeed)));

    private static final Structure<Double> SHADING = new Structure<>(
            Scene.DEFAULT_AMBIENT,
            List.of(written("ambient", new Decimal(SceneLimits.AMBIENT), ambient -> ambient, (_, ambient) -> ambient)));

    static final Field<Scene, Integer> VERSION =
            required("version", new Version(Scene.VERSION), _ -> Scene.VERSION, (scene, _) -> scene);

    /** The skybox's path is as it stands in the file. */
    static final Structure<Scene> SCENE = new Structure<>(
            Scene.under(Path.of("")),
            List.of(
                    // For editors.
                    sparse(SchemaReference.FIELD, REFERENCE, _ -> "", (scene, _) -> scene),
                    VERSION,
                    written("name", new Text(0, SceneLimits.MAX_NAME_LENGTH), Scene::name, Scene::withName),
                    written(
                            "description",
                            new Text(0, SceneLimits.MAX_DESCRIPTION_LENGTH),
                            Scene::description,
                            Scene::withDescription),
                    required("camera", CAMERA, Scene::camera, Scene::withCamera),
                    required("light", LIGHT, Scene::light, Scene::withLight),
                    required("plane", PLANE, Scene::plane, Scene::withPlane),
                    required(
                            "skybox",
                            new FilePath(new Text(1, SceneLimits.MAX_PATH_LENGTH)),
                            Scene::skybox,
                            Scene::withSkybox),
                    sparse(
                            "skyRotation",
                            new Decimal(SceneLimits.SKY_ROTATION),
                            Scene::skyRotationDegrees,
                            Scene::withSkyRotation),
                    sparse(
                            "skyStrength",
                            new Decimal(SceneLimits.SKY_STRENGTH),
                            Scene::skyStrength,
                            Scene::withSkyStrength),
                    written("shading", SHADING, Scene::ambient, Scene::withAmbient),
                    written("rendering", RENDERING, Scene::settings, Scene::withSettings),
                    sparse("physics", PHYSICS, Scene::physics, Scene::withPhysics),
                    sparse(
                            "pour",
                            ValueType.present(POUR),
                            Scene::pour,
                            (scene, pour) -> scene.withPour(pour.orElseThrow())),
                    required(
                            "spheres",
                            new Lines<>(new Array<>(
                                    SPHERE,
                                    0,
                                    SceneLimits.MAX_SPHERES,
                                    "an array of 0 to " + SceneLimits.MAX_SPHERES + " spheres")),
                            Scene::spheres,
                            Scene::withSpheres)));

    private SceneFormat() {}
}
