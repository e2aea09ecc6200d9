package dev.twister.kernel;

/** Where each fact stands in the kernel's arrays; the only place that says so. */
public final class Layout {
    /** {@code int[] dimensions}: width and height of the whole picture, the rows of it that are drawn, the bodies. */
    public static final int WIDTH = 0;

    public static final int HEIGHT = 1;
    public static final int FIRST_ROW = 2;
    public static final int ROWS = 3;

    /** How many bodies there are: light, plane and spheres. */
    public static final int BODIES = 4;

    public static final int DIMENSIONS_LENGTH = 5;

    /** {@code float[] camera}: position, then the directions right, up and forward, then the eye's distance. */
    public static final int CAMERA_POSITION = 0;

    public static final int CAMERA_RIGHT = 3;
    public static final int CAMERA_UP = 6;
    public static final int CAMERA_FORWARD = 9;

    /** {@code 1 / tan(fov / 2)}: how far the eye is behind the viewport, whose shorter half side is 1. */
    public static final int CAMERA_EYE_DISTANCE = 12;

    public static final int CAMERA_LENGTH = 13;

    /** {@code float[] rayTracingProperties}; counts are whole numbers held exactly by a float. */
    public static final int SHADOW_SAMPLES = 0;

    public static final int BOUNCES = 1;
    public static final int PIXEL_SAMPLES = 2;

    /** 2^exposure. */
    public static final int EXPOSURE_SCALE = 3;

    /** One of {@link ToneMapping}'s numbers. */
    public static final int TONE_MAP = 4;

    /** 1 where the sRGB curve follows the tone map, else 0. */
    public static final int SRGB = 5;

    public static final int AMBIENT = 6;

    /** The plane's second colour (three floats); its first is the body's own. */
    public static final int PLANE_ODD_COLOR = 7;

    public static final int PROPERTIES_LENGTH = 10;

    /** Indices of bodies: {@code bodyPositions} and {@code bodyColors} have three floats each, the others one. */
    public static final int LIGHT = 0;

    public static final int PLANE = 1;
    public static final int FIRST_SPHERE = 2;

    /** What a closest hit is where nothing is hit. */
    public static final int NOTHING = -1;

    /** {@code int[] skyboxDimensions}: width and height in texels. */
    public static final int SKYBOX_WIDTH = 0;

    public static final int SKYBOX_HEIGHT = 1;
    public static final int SKYBOX_DIMENSIONS_LENGTH = 2;

    /**
     * {@code float[] hierarchy}, a bounding volume hierarchy over the spheres: first the spheres, each of a leaf beside the
     * others of it, then the nodes. A sphere's centre, radius and body (a whole number, exact in a float).
     */
    public static final int SPHERE_CENTER = 0;

    public static final int SPHERE_RADIUS = 3;
    public static final int SPHERE_BODY = 4;

    /** From one sphere to the next. */
    public static final int SPHERE_STRIDE = 5;

    /** A node's box: its centre, and half of its sides. */
    public static final int NODE_CENTER = 0;

    public static final int NODE_HALF = 3;

    /** Where in the array the node's first sphere is, or its first child; the second child follows the first. */
    public static final int NODE_LINK = 6;

    /** How many spheres are in the leaf; less than 0 where the node has children. */
    public static final int NODE_SPHERES = 7;

    /** From one node to the next. */
    public static final int NODE_STRIDE = 8;

    /** What stands for no node. */
    public static final int NO_NODE = -1;

    /** No node has more ancestors. */
    public static final int MOST_ANCESTORS = 48;

    /** How many candidates a shadow remembers; where there are more, each sample looks through the hierarchy. */
    public static final int MOST_CANDIDATES = 64;

    /** From one remembered candidate to the next: its place in the shadow's frame a, u, w, and its radius squared. */
    public static final int CANDIDATE_STRIDE = 4;

    /**
     * {@code float[] scratch}, a thread's own: what a shadow remembers of its candidates, then the nodes to come back to
     * (two floats each, one a generation).
     */
    public static final int SCRATCH_STACK = CANDIDATE_STRIDE * MOST_CANDIDATES;

    public static final int SCRATCH_LENGTH = SCRATCH_STACK + 2 * MOST_ANCESTORS;

    /** The largest reflectivity, at which a body is a perfect mirror. */
    public static final float MAX_REFLECTIVITY = 128f;

    private Layout() {}

    /** Where the root is in the hierarchy of a scene of so many bodies: after the spheres. */
    public static int root(int bodies) {
        return SPHERE_STRIDE * (bodies - FIRST_SPHERE);
    }
}
