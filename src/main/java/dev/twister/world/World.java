package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.kernel.ToneMapping;
import dev.twister.scene.Camera;
import dev.twister.scene.Light;
import dev.twister.scene.Plane;
import dev.twister.scene.RenderSettings;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.ToneMap;
import dev.twister.scene.Vector3;
import dev.twister.sky.Skybox;
import java.util.List;

/**
 * The living state between frames: what a scene said, as it is now. Used by one thread; engines see snapshots.
 */
public final class World {
    private final int[] skyboxDimensions;
    private final float[] skybox;
    private final float[] bodySizes;
    private final float[] bodyColors;
    private final float[] bodyReflectivities;
    private final Rgb planeOddColor;
    private final double ambient;
    private float[] bodyPositions;
    private int bodies;
    private float[] hierarchy = {};
    private boolean hierarchyHolds;
    private Camera camera;
    private RenderSettings settings;
    private float[] shadowDisc;
    private float[] pixelOffsets;

    private World(Scene scene, Skybox sky) {
        List<Sphere> spheres = scene.allSpheres();
        bodies = Layout.FIRST_SPHERE + scene.spheres().size();
        int room = Layout.FIRST_SPHERE + spheres.size();
        bodyPositions = new float[3 * room];
        bodySizes = new float[room];
        bodyColors = new float[3 * room];
        bodyReflectivities = new float[room];
        Light light = scene.light();
        put(Layout.LIGHT, light.position(), light.radius(), light.color(), 0);
        Plane plane = scene.plane();
        put(Layout.PLANE, new Vector3(0, plane.height(), 0), plane.size(), plane.evenColor(), plane.reflectivity());
        int body = Layout.FIRST_SPHERE;
        for (Sphere sphere : spheres) {
            put(body++, sphere.position(), sphere.radius(), sphere.color(), sphere.reflectivity());
        }
        planeOddColor = plane.oddColor();
        ambient = scene.ambient();
        skybox = sky.radiance();
        skyboxDimensions = new int[Layout.SKYBOX_DIMENSIONS_LENGTH];
        skyboxDimensions[Layout.SKYBOX_WIDTH] = sky.width();
        skyboxDimensions[Layout.SKYBOX_HEIGHT] = sky.height();
        camera = scene.camera();
        settings = scene.settings();
        shadowDisc = SunflowerDisc.points(settings.shadowSamples());
        pixelOffsets = PixelOffsets.places(settings.samplesPerPixel());
    }

    /** The world at the start, when nothing has been poured yet. */
    public static World of(Scene scene, Skybox sky) {
        return new World(scene, sky);
    }

    public Camera camera() {
        return camera;
    }

    public void setCamera(Camera newCamera) {
        camera = newCamera;
    }

    public RenderSettings settings() {
        return settings;
    }

    public void setSettings(RenderSettings newSettings) {
        if (newSettings.shadowSamples() != settings.shadowSamples()) {
            shadowDisc = SunflowerDisc.points(newSettings.shadowSamples());
        }
        if (newSettings.samplesPerPixel() != settings.samplesPerPixel()) {
            pixelOffsets = PixelOffsets.places(newSettings.samplesPerPixel());
        }
        settings = newSettings;
    }

    /**
     * Moves the bodies.
     *
     * @param positions {@code float[3 * room]}, laid out as {@link FrameInput#bodyPositions}: the light's and the plane's
     *     places too, then those of all spheres, poured or not; taken over, nobody may write to it any more
     * @param newBodies how many of them are there, light and plane included
     * @throws IllegalArgumentException where the length is another one, or there cannot be so many bodies
     */
    public void setBodyPositions(float[] positions, int newBodies) {
        if (positions.length != bodyPositions.length) {
            throw new IllegalArgumentException(positions.length + " coordinates for " + bodySizes.length + " bodies");
        }
        if (newBodies < Layout.FIRST_SPHERE || newBodies > bodySizes.length) {
            throw new IllegalArgumentException(newBodies + " bodies of " + bodySizes.length);
        }
        bodyPositions = positions;
        bodies = newBodies;
        hierarchyHolds = false;
    }

    /**
     * The world as it is now, for an engine to draw whole. Where bodies were moved, or poured, since the last one, the
     * hierarchy over the spheres is built anew.
     */
    public FrameInput snapshot() {
        if (!hierarchyHolds) {
            hierarchy = SphereHierarchy.of(bodyPositions, bodySizes, bodies);
            hierarchyHolds = true;
        }
        return new FrameInput(
                dimensions(),
                CameraBasis.of(camera),
                properties(),
                bodyPositions,
                bodySizes,
                bodyColors,
                bodyReflectivities,
                skybox,
                skyboxDimensions,
                shadowDisc,
                pixelOffsets,
                hierarchy);
    }

    private int[] dimensions() {
        int[] dimensions = new int[Layout.DIMENSIONS_LENGTH];
        dimensions[Layout.WIDTH] = settings.width();
        dimensions[Layout.HEIGHT] = settings.height();
        dimensions[Layout.ROWS] = settings.height();
        dimensions[Layout.BODIES] = bodies;
        return dimensions;
    }

    private float[] properties() {
        float[] properties = new float[Layout.PROPERTIES_LENGTH];
        properties[Layout.SHADOW_SAMPLES] = settings.shadowSamples();
        properties[Layout.BOUNCES] = settings.bounces();
        properties[Layout.PIXEL_SAMPLES] = settings.samplesPerPixel();
        properties[Layout.EXPOSURE_SCALE] = (float) Math.pow(2, settings.exposure());
        properties[Layout.TONE_MAP] = toneMapNumber(settings.toneMap());
        properties[Layout.SRGB] = settings.srgb() ? 1 : 0;
        properties[Layout.AMBIENT] = (float) ambient;
        putColor(properties, Layout.PLANE_ODD_COLOR, planeOddColor);
        return properties;
    }

    private static int toneMapNumber(ToneMap toneMap) {
        return switch (toneMap) {
            case CLAMP -> ToneMapping.CLAMP;
            case REINHARD -> ToneMapping.REINHARD;
            case ACES -> ToneMapping.ACES;
        };
    }

    private void put(int body, Vector3 position, double size, Rgb color, double reflectivity) {
        bodyPositions[3 * body] = (float) position.x();
        bodyPositions[3 * body + 1] = (float) position.y();
        bodyPositions[3 * body + 2] = (float) position.z();
        bodySizes[body] = (float) size;
        putColor(bodyColors, 3 * body, color);
        bodyReflectivities[body] = (float) reflectivity;
    }

    private static void putColor(float[] array, int at, Rgb color) {
        array[at] = (float) color.red();
        array[at + 1] = (float) color.green();
        array[at + 2] = (float) color.blue();
    }
}
