package dev.twister.scene.property;

/** Ranges of more than one property of a scene, and how many of a thing it may have. */
public final class SceneLimits {
    /** Keeps every position, and its square, far from where floats overflow or lose meters. */
    public static final Range POSITION = new Range(-1e6, 1e6, "meters");

    /** Above 0, so that no normal is divided by 0. */
    public static final Range LENGTH = new Range(1e-6, 1e6, "meters");

    /** Of a shape; 0 where it is flat. */
    public static final Range SHAPE_SIDE = new Range(0, 1e6, "meters");

    public static final Range ANGLE = new Range(-1e6, 1e6, "degrees");
    public static final Range FACTOR = new Range(1e-6, 1e6);
    public static final Range SHARE = new Range(0, 1);
    public static final Range RADIANCE = new Range(0, 1e6);
    public static final Range KEYFRAME_TIME = new Range(0, 86_400, "seconds");

    /** Of an animation of a mesh's file. */
    public static final Range CLIP_TIME = new Range(-1e6, 1e6, "seconds");

    /** Wide enough for every animated property; each has a range of its own. */
    public static final Range ANIMATED = new Range(-1e9, 1e9);

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
