package dev.twister.scene.property;

import dev.twister.scene.Rendering;

/** The values that a scene file may have. {@code scenes/scene.schema.json} says the same to editors. */
public final class SceneLimits {
    /** Keeps every position, and its square, far from where floats overflow or lose meters. */
    public static final Range POSITION = new Range(-1e6, 1e6, "meters");

    /** Above 0, so that no normal is divided by 0. */
    public static final Range LENGTH = new Range(1e-6, 1e6, "meters");

    /** Of a shape; 0 where it is flat. */
    public static final Range SHAPE_SIDE = new Range(0, 1e6, "meters");

    public static final Range YAW = new Range(-1e6, 1e6, "degrees");
    public static final Range PITCH = new Range(-90, 90, "degrees");
    public static final Range ROTATION = YAW;
    public static final Range SCALE = new Range(1e-6, 1e6);
    public static final Range SMOOTH = new Range(0, 180, "degrees");
    public static final Range FIELD_OF_VIEW = new Range(1, 179, "degrees");
    public static final Range APERTURE = new Range(0, 1e6, "meters");
    public static final Range FOCUS_DISTANCE = LENGTH;
    public static final Range KEYFRAME_TIME = new Range(0, 86_400, "seconds");

    /** Wide enough for every animated property; each has a range of its own. */
    public static final Range ANIMATED = new Range(-1e9, 1e9);

    public static final Range ALBEDO = new Range(0, 1);
    public static final Range RADIANCE = new Range(0, 1e6);
    public static final Range REFLECTIVITY = new Range(0, 128);
    public static final Range ROUGHNESS = new Range(0, 1);
    public static final Range METALLIC = new Range(0, 1);
    public static final Range EMISSION_STRENGTH = new Range(0, 1e6);
    public static final Range LIGHT_STRENGTH = new Range(0, 1e9, "m^2");
    public static final Range LIGHT_SHARE = new Range(0, 1000);
    public static final Range CLAMP = new Range(0, 1e6);
    public static final Range TRANSMISSION = new Range(0, 1);
    public static final Range IOR = new Range(1, 4);
    public static final Range AMBIENT = new Range(0, 1);
    public static final Range SKY_ROTATION = YAW;
    public static final Range SKY_STRENGTH = new Range(0, 1e6);
    public static final Range SIDE = new Range(1, Rendering.MAX_SIDE, "pixels");
    public static final Range SHADOW_SAMPLES = new Range(1, Rendering.MAX_SHADOW_SAMPLES);
    public static final Range BOUNCES = new Range(0, Rendering.MAX_BOUNCES);
    public static final Range SAMPLES_PER_PIXEL = new Range(1, Rendering.MAX_SAMPLES_PER_PIXEL);
    public static final Range EXPOSURE =
            new Range(-Rendering.MAX_EXPOSURE_STOPS, Rendering.MAX_EXPOSURE_STOPS, "stops");

    public static final Range GRAVITY = new Range(-1000, 1000, "m/s^2");
    public static final Range ELASTICITY = new Range(0, 1);
    public static final Range FRICTION = new Range(0, 10);
    public static final Range DAMPING = new Range(0, 100, "1/s");
    public static final Range POUR_RATE = new Range(1e-3, 1e6, "spheres a second");
    public static final Range POUR_SPEED = new Range(1e-3, 100, "m/s");
    public static final Range SEED = new Range(0, Integer.MAX_VALUE);

    public static final int MAX_LIGHTS = 4096;
    public static final int MAX_LIGHT_GROUPS = 12;
    public static final int MAX_SPHERES = 500_000;
    public static final int MAX_MESHES = 10_000;
    public static final int MAX_MATERIALS = 256;
    public static final int MAX_KEYFRAMES = 10_000;
    public static final int MAX_TRACKS = 10_000;
    public static final int MAX_VIEWS = 1000;
    public static final int MAX_NAME_LENGTH = 200;
    public static final int MAX_DESCRIPTION_LENGTH = 2000;
    public static final int MAX_PATH_LENGTH = 1000;

    private SceneLimits() {}
}
