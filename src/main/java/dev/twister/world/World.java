package dev.twister.world;

import dev.twister.kernel.Aspect;
import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.sky.Skybox;
import java.util.List;
import java.util.Optional;

/** The mutable state between frames, initialized from a scene. For use by one thread; engines get snapshots. */
public final class World {
    private static final double DEGREES_PER_TURN = 360;

    /** Lower bound of a color whose logarithm is taken. */
    private static final double DARKEST = 1e-9;

    private final Vector3 origin;
    private final float[] texels;
    private float[] looks;
    private final SceneImages images;
    private final SceneMeshes sceneMeshes;
    private final float[] meshes;
    private final float[] instances;
    private final int room;
    private final boolean plain;
    private final Rgb planeOddColor;
    private final double ambient;
    private final double skyTurn;
    private final double skyStrength;
    private final float[] places;
    private int bodies;
    private float[] floats = {};
    private boolean floatsHold;
    private Camera camera;
    private Rendering settings;
    private float[] shadowDisc;
    private float[] pixelSamples;
    private Optional<Emitters> emitters = Optional.empty();
    private int emittersOf;

    private World(Scene scene, SceneImages images, SceneMeshes sceneMeshes) {
        origin = originOf(scene);
        List<Sphere> spheres = scene.allSpheres();
        bodies = Layout.FIRST_SPHERE + scene.spheres().size();
        room = Layout.FIRST_SPHERE + spheres.size();
        this.images = images;
        this.sceneMeshes = sceneMeshes;
        meshes = sceneMeshes.floats();
        List<MeshBody> meshBodies = MeshBody.of(scene, sceneMeshes, origin);
        instances = InstanceTable.of(meshBodies, meshes, room);
        places = new float[Layout.PLACE_STRIDE * (room + meshBodies.size())];
        looks = new float[Layout.LOOK_STRIDE * (room + meshBodies.size())];
        Light light = scene.lights().first();
        put(Layout.LIGHT, light.position(), light.radius(), Material.DEFAULT.withColor(light.color()), 0);
        Ground plane = scene.ground();
        TexelTable table = new TexelTable(images);
        Vector3 middle = new Vector3(0, plane.height(), 0);
        put(Layout.PLANE, middle, plane.size(), plane.material(), table.number(plane.material()));
        int body = Layout.FIRST_SPHERE;
        for (Sphere sphere : spheres) {
            Material material = sphere.material();
            put(body++, sphere.position(), sphere.radius(), material, table.number(material));
        }
        for (MeshBody mesh : meshBodies) {
            Material material = mesh.material();
            MeshBox box = MeshBox.of(mesh, meshes);
            putPlace(body, box.center(), box.radius());
            putLooks(body++, material, table.number(material));
        }
        putColor(looks, Layout.LOOK_EMISSION, LightStrength.radiance(light, scene));
        plain = arePlain(looks);
        looks = table.withTable(looks);
        texels = table.images();
        planeOddColor = plane.oddColor();
        ambient = scene.shading().ambient();
        skyTurn = scene.sky().rotationDegrees() / DEGREES_PER_TURN;
        skyStrength = scene.sky().strength();
        camera = scene.camera();
        settings = scene.rendering();
        shadowDisc = SunflowerDisc.points(settings.shadowSamples());
        pixelSamples = PixelSamples.of(settings.samplesPerPixel());
    }

    /** The world at the start, before any sphere is poured. */
    public static World of(Scene scene, Skybox sky) {
        return of(scene, SceneImages.of(sky));
    }

    /** As above, for a scene with textures. */
    public static World of(Scene scene, SceneImages images) {
        return of(scene, images, SceneMeshes.NONE);
    }

    /**
     * As above, for a scene with meshes.
     *
     * @throws IllegalArgumentException if one of the scene's textures or meshes is missing
     */
    public static World of(Scene scene, SceneImages images, SceneMeshes meshes) {
        return new World(scene, images, meshes);
    }

    /** The {@link #origin} of every world of a scene. */
    public static Vector3 originOf(Scene scene) {
        return Origin.near(scene.camera().position());
    }

    /** Origin of the snapshots' coordinates, in the scene's coordinates; near the scene's camera. */
    public Vector3 origin() {
        return origin;
    }

    /**
     * Whether the origin is near enough to a camera; otherwise a new world of the scene gives a more accurate picture.
     */
    public boolean isNear(Camera other) {
        return Origin.isNear(origin, other.position());
    }

    /** The images of this world. */
    public SceneImages images() {
        return images;
    }

    /** The meshes of this world. */
    public SceneMeshes meshes() {
        return sceneMeshes;
    }

    public Camera camera() {
        return camera;
    }

    public void setCamera(Camera newCamera) {
        camera = newCamera;
    }

    public Rendering settings() {
        return settings;
    }

    public void setSettings(Rendering newSettings) {
        if (newSettings.shadowSamples() != settings.shadowSamples()) {
            shadowDisc = SunflowerDisc.points(newSettings.shadowSamples());
        }
        if (newSettings.samplesPerPixel() != settings.samplesPerPixel()) {
            pixelSamples = PixelSamples.of(newSettings.samplesPerPixel());
        }
        settings = newSettings;
    }

    /**
     * Moves the bodies, except meshes.
     *
     * @param positions {@code float[3 * room]}: the centers of the light, the plane and all spheres, including those
     *     not poured yet, relative to the {@link #origin}, in meters
     * @param newBodies number of present bodies, including light and plane
     * @throws IllegalArgumentException if the length is wrong, or there is no room for that number of bodies
     */
    public void setBodyPositions(float[] positions, int newBodies) {
        if (positions.length != 3 * room) {
            throw new IllegalArgumentException(positions.length + " coordinates for " + room + " bodies");
        }
        if (newBodies < Layout.FIRST_SPHERE || newBodies > room) {
            throw new IllegalArgumentException(newBodies + " bodies of " + room);
        }
        for (int body = 0; body < room; body++) {
            System.arraycopy(positions, 3 * body, places, Layout.PLACE_STRIDE * body, 3);
        }
        bodies = newBodies;
        floatsHold = false;
    }

    /**
     * The current state as an engine's input for the whole picture. If bodies have moved or been poured since the last
     * snapshot, the hierarchy over the spheres is rebuilt.
     */
    public FrameInput snapshot() {
        if (!floatsHold) {
            floats = SphereHierarchy.of(places, bodies, room, instances);
            floatsHold = true;
        }
        int firstMesh = instances.length > 0 ? room : Layout.NO_MESHES;
        int end = places.length / Layout.PLACE_STRIDE;
        Bodies moved = new Bodies(floats, looks, meshes, room, end, firstMesh, plain, origin);
        float[] values = values(moved);
        if (settings.integrator() == Integrator.WHITTED) {
            return new FrameInput(View.of(values, shadowDisc, pixelSamples, Aspect.FULL), moved, texels);
        }
        Emitters tables = emitters(moved);
        tables.write(values);
        return new FrameInput(
                View.of(values, shadowDisc, pixelSamples, Aspect.FULL),
                moved.withLooks(tables.looks()),
                tables.images());
    }

    /** The tables of path tracing, which do not depend on where bodies are. */
    private Emitters emitters(Bodies moved) {
        if (emitters.isEmpty() || emittersOf != bodies) {
            emitters = Optional.of(Emitters.of(moved, bodies, texels, images.sky(), skyStrength > 0));
            emittersOf = bodies;
        }
        return emitters.get();
    }

    private float[] values(Bodies moved) {
        float[] values = new float[Layout.SAMPLES];
        Camera seen = camera.withPosition(moved.seen(camera.position()));
        System.arraycopy(CameraBasis.of(seen), 0, values, 0, Layout.CAMERA_LENGTH);
        values[Layout.SHADOW_SAMPLES] = settings.shadowSamples();
        values[Layout.BOUNCES] = settings.bounces();
        values[Layout.PIXEL_SAMPLES] = settings.samplesPerPixel();
        putTone(values, settings);
        values[Layout.AMBIENT] = (float) ambient;
        putColor(values, Layout.PLANE_ODD_COLOR, planeOddColor);
        values[Layout.SKY_TURN] = (float) (skyTurn - Math.floor(skyTurn)) % 1f;
        values[Layout.SKY_STRENGTH] = (float) skyStrength;
        values[Layout.SKY_WIDTH] = images.sky().width();
        values[Layout.SKY_HEIGHT] = images.sky().height();
        values[Layout.WIDTH] = settings.width();
        values[Layout.HEIGHT] = settings.height();
        values[Layout.ROWS] = settings.height();
        values[Layout.BODIES] = bodies;
        values[Layout.FIRST_MESH] = moved.firstMesh();
        values[Layout.ROOT] = moved.root(bodies);
        values[Layout.INSTANCES] = moved.instances();
        values[Layout.TEXTURES] = moved.textures();
        values[Layout.CLAMP] = (float) settings.clamp();
        values[Layout.FIRST_SAMPLE] = PixelSamples.first(settings.samplesPerPixel());
        return values;
    }

    @SuppressWarnings("EnumOrdinal") // a test checks that the kernel's numbers match the constants' order
    static void putTone(float[] frame, Rendering settings) {
        frame[Layout.EXPOSURE_SCALE] = (float) Math.pow(2, settings.exposure());
        frame[Layout.TONE_MAP] = settings.toneMap().ordinal();
        frame[Layout.SRGB] = settings.srgb() ? 1 : 0;
    }

    private static boolean arePlain(float[] looks) {
        for (int look = Layout.LOOK_STRIDE; look < looks.length; look++) {
            if (look % Layout.LOOK_STRIDE > Layout.LOOK_REFLECTIVITY && looks[look] != 0) {
                return false;
            }
        }
        return true;
    }

    private void put(int body, Vector3 position, double size, Material material, int texture) {
        putPlace(body, position.minus(origin), size);
        putLooks(body, material, texture);
    }

    private void putPlace(int body, Vector3 seen, double size) {
        int place = Layout.PLACE_STRIDE * body;
        places[place] = (float) seen.x();
        places[place + 1] = (float) seen.y();
        places[place + 2] = (float) seen.z();
        places[place + Layout.PLACE_SIZE] = (float) size;
    }

    private void putLooks(int body, Material material, int texture) {
        int look = Layout.LOOK_STRIDE * body;
        putColor(looks, look, material.color());
        boolean fresnel = material.isByFresnel();
        float reflectivity = (float) material.whittedReflectivity();
        float transmission = (float) material.transmission();
        looks[look + Layout.LOOK_REFLECTIVITY] = reflectivity;
        looks[look + Layout.LOOK_TRANSMISSION] = transmission;
        // Properties without effect stay 0, so that the body counts as plain.
        boolean glossy = fresnel || reflectivity > 0 || transmission > 0;
        looks[look + Layout.LOOK_ROUGHNESS] = glossy ? (float) material.roughness() : 0;
        looks[look + Layout.LOOK_IOR] = fresnel || transmission > 0 ? (float) material.ior() : 0;
        looks[look + Layout.LOOK_METALLIC] = (float) (fresnel ? -1 - material.metallic() : material.metallic());
        putColor(looks, look + Layout.LOOK_EMISSION, material.emission().radiance());
        boolean oneSided = !material.emission().isNone() && !material.emission().doubleSided();
        looks[look + Layout.LOOK_EMITTER] = oneSided ? -1 : 0;
        material.attenuation().distance().ifPresent(distance -> {
            Rgb color = material.attenuation().color();
            looks[look + Layout.LOOK_ABSORPTION] = absorption(color.red(), distance);
            looks[look + Layout.LOOK_ABSORPTION + 1] = absorption(color.green(), distance);
            looks[look + Layout.LOOK_ABSORPTION + 2] = absorption(color.blue(), distance);
        });
        looks[look + Layout.LOOK_TEXTURE] = texture;
    }

    /** Per meter, so that {@code color} is left after the distance. */
    private static float absorption(double color, double distance) {
        return (float) (-Math.log(Math.max(color, DARKEST)) / distance);
    }

    private static void putColor(float[] array, int at, Rgb color) {
        array[at] = (float) color.red();
        array[at + 1] = (float) color.green();
        array[at + 2] = (float) color.blue();
    }
}
