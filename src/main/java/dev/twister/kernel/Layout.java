package dev.twister.kernel;

/** Where each fact stands in the kernel's arrays; the only place that says so. */
public final class Layout {
    /** {@code int[] dimensions}: width and height of the whole picture, the rows of it that are drawn, the bodies. */
    public static final int WIDTH = 0;

    public static final int HEIGHT = 1;
    public static final int FIRST_ROW = 2;
    public static final int ROWS = 3;

    /** How many bodies there are without meshes: light, plane and spheres. */
    public static final int BODIES = 4;

    public static final int DIMENSIONS_LENGTH = 5;

    /** {@code float[] camera}: position, then the directions right, up and forward, then the eye's distance. */
    public static final int CAMERA_POSITION = 0;

    public static final int CAMERA_RIGHT = 3;
    public static final int CAMERA_UP = 6;
    public static final int CAMERA_FORWARD = 9;

    /** {@code 1 / tan(fov / 2)}: how far the eye is behind the viewport, whose shorter half side is 1. */
    public static final int CAMERA_EYE_DISTANCE = 12;

    /** The lens's radius in meters; 0 for a pinhole. */
    public static final int CAMERA_APERTURE = 13;

    /** How far ahead the plane is that is sharp, in meters. */
    public static final int CAMERA_FOCUS = 14;

    public static final int CAMERA_LENGTH = 15;

    /**
     * {@code float[] pixelSamples}, {@value #SAMPLE_STRIDE} floats a sample: its place in the pixel, x and y in (0, 1);
     * then pairs of numbers in [0, 1), one pair for the lens and one for the surface of each of the first
     * {@value #SAMPLE_SURFACES} bounces, which the next ones take again.
     */
    public static final int SAMPLE_LENS = 2;

    public static final int SAMPLE_SURFACE = 4;
    public static final int SAMPLE_SURFACES = 6;
    public static final int SAMPLE_STRIDE = SAMPLE_SURFACE + 2 * SAMPLE_SURFACES;

    /** {@code float[] properties}; counts are whole numbers held exactly by a float. */
    public static final int SHADOW_SAMPLES = 0;

    public static final int BOUNCES = 1;
    public static final int PIXEL_SAMPLES = 2;

    /** 2^exposure. */
    public static final int EXPOSURE_SCALE = 3;

    /** One of {@link Tone}'s numbers. */
    public static final int TONE_MAP = 4;

    /** 1 where the sRGB curve follows the tone map, else 0. */
    public static final int SRGB = 5;

    public static final int AMBIENT = 6;

    /** The plane's second color (three floats); its first is the body's own. */
    public static final int PLANE_ODD_COLOR = 7;

    /** How far the panorama is turned to the right, in whole turns, in [0, 1). */
    public static final int SKY_TURN = 10;

    /** What the panorama's radiance is multiplied by, 0 or more. */
    public static final int SKY_STRENGTH = 11;

    public static final int PROPERTIES_LENGTH = 12;

    /** Indices of bodies. */
    public static final int LIGHT = 0;

    public static final int PLANE = 1;
    public static final int FIRST_SPHERE = 2;

    /** What a closest hit is where nothing is hit. */
    public static final int NOTHING = -1;

    /**
     * Value of the argument {@code firstMesh} where there are no meshes; else it is the first mesh's body: meshes come
     * after all spheres that may come to be.
     */
    public static final int NO_MESHES = 0;

    /**
     * {@code float[] places}, {@value #PLACE_STRIDE} floats a body: the center, then a sphere's radius or the plane's
     * side. A mesh has those of a sphere around it.
     */
    public static final int PLACE_SIZE = 3;

    public static final int PLACE_STRIDE = 4;

    /** {@code float[] looks}, {@value #LOOK_STRIDE} floats a body: the color, then what it is made of. */
    public static final int LOOK_REFLECTIVITY = 3;

    /** In [0, 1]; 0 where no ray goes on from the body. */
    public static final int LOOK_ROUGHNESS = 4;

    /** In [0, 1]. */
    public static final int LOOK_TRANSMISSION = 5;

    /** Index of refraction in [1, 4]; 0 where nothing is transmitted. */
    public static final int LOOK_IOR = 6;

    /** Which of the pictures after the panorama multiplies the color, from 1 on; 0 for none. */
    public static final int LOOK_TEXTURE = 7;

    public static final int LOOK_STRIDE = 8;

    /**
     * {@code int[] skyDimensions}: the panorama's width and height in texels; then, for each texture, where its first
     * float is in {@code sky}, its width and its height.
     */
    public static final int SKY_WIDTH = 0;

    public static final int SKY_HEIGHT = 1;
    public static final int SKY_DIMENSIONS_LENGTH = 2;
    public static final int TEXTURE_START = 0;
    public static final int TEXTURE_WIDTH = 1;
    public static final int TEXTURE_HEIGHT = 2;
    public static final int TEXTURE_STRIDE = 3;

    /**
     * {@code float[] hierarchy}, a bounding volume hierarchy over the spheres: first the spheres, each of a leaf beside
     * the others of it, then the nodes. A sphere's center and radius as in {@code places}, then its body (a whole
     * number, exact in a float).
     */
    public static final int SPHERE_RADIUS = PLACE_SIZE;

    public static final int SPHERE_BODY = 4;

    /** From one sphere to the next. */
    public static final int SPHERE_STRIDE = 5;

    /** A node's box: its center, and half of its sides. */
    public static final int NODE_CENTER = 0;

    public static final int NODE_HALF = 3;

    /** Where in the array the node's first sphere is, or its first child; the second child follows the first. */
    public static final int NODE_LINK = 6;

    /** How many spheres (or meshes, or triangles) are in the leaf; less than 0 where the node has children. */
    public static final int NODE_SPHERES = 7;

    /** From one node to the next. */
    public static final int NODE_STRIDE = 8;

    /**
     * After the spheres' part, {@link #instances}: how many nodes there are over the meshes, those nodes, the first the
     * root, then the meshes as instances of {@code meshes}, in the order of the leaves. Links are numbers of nodes and
     * instances. An instance: rows of three coefficients and an offset that take a point of the world to the mesh's own
     * coordinates, and back.
     */
    public static final int INSTANCE_TO_MESH = 0;

    public static final int INSTANCE_TO_WORLD = 12;

    /** The body. */
    public static final int INSTANCE_BODY = 24;

    /** Where in {@code meshes} the mesh starts, by {@value #MESH_ALIGNMENT}, so that a float has it exactly. */
    public static final int INSTANCE_MESH = 25;

    /** How many nodes and triangles the mesh has, vertices with normals, and vertices with places in a texture. */
    public static final int INSTANCE_NODES = 26;

    public static final int INSTANCE_TRIANGLES = 27;
    public static final int INSTANCE_NORMALS = 28;
    public static final int INSTANCE_TEXTURE_PLACES = 29;
    public static final int INSTANCE_STRIDE = 30;

    /**
     * {@code float[] meshes}, one mesh after the other, however many bodies show it: nodes as in {@code hierarchy}, the
     * root first, with numbers of nodes and triangles as links; triangles in the order of the leaves; then, where there
     * are any, the vertices' unit normals, and their places in the texture (u, v). A triangle: its corners, then their
     * vertices.
     */
    public static final int MESH_ALIGNMENT = 256;

    public static final int TRIANGLE_VERTICES = 9;
    public static final int TRIANGLE_STRIDE = 12;

    /** What stands for no node. */
    public static final int NO_NODE = -1;

    /** No node has more ancestors. */
    public static final int MOST_ANCESTORS = 48;

    /**
     * How many candidates a shadow remembers; where there are more, each sample looks through the hierarchy. So few
     * that PoCL has room for the scratch of 4,096 pixels on a stack of 8 MB.
     */
    public static final int MOST_CANDIDATES = 32;

    /** From one remembered candidate to the next: its place in the shadow's frame a, u, w, and its radius squared. */
    public static final int CANDIDATE_STRIDE = 4;

    /**
     * {@code float[] scratch}, a thread's own: what a shadow remembers of its candidates, then the nodes to come back
     * to (two floats each, one a generation).
     */
    public static final int SCRATCH_STACK = CANDIDATE_STRIDE * MOST_CANDIDATES;

    /**
     * With materials of any kind the scratch goes on: what each remembered candidate transmits, then the waiting rays.
     */
    public static final int SCRATCH_TRANSMISSIONS = SCRATCH_STACK + 2 * MOST_ANCESTORS;

    public static final int SCRATCH_RAYS = SCRATCH_TRANSMISSIONS + MOST_CANDIDATES;

    /** Of two rays the fainter is followed first, and it has no more than half of the throughput: no more rays wait. */
    public static final int MOST_WAITING_RAYS = 10;

    /** A waiting ray: the first floats of its path, and how many surfaces it has left. */
    public static final int RAY_BOUNCE = 12;

    public static final int RAY_STRIDE = 13;

    /** Where meshes are walked through, their nodes to come back to: a ray's use the place of a shadow's candidates. */
    public static final int SCRATCH_RAY_NODES = 0;

    public static final int SCRATCH_SHADOW_NODES = SCRATCH_STACK + MOST_ANCESTORS;

    /** How long the scratch is where all materials are {@link Material#PLAIN}. */
    public static final int PLAIN_SCRATCH_LENGTH = SCRATCH_TRANSMISSIONS;

    public static final int SCRATCH_LENGTH = SCRATCH_RAYS + RAY_STRIDE * MOST_WAITING_RAYS;

    /**
     * {@code float[] path}, a thread's own: the ray, the body that it leaves and whether it goes on inside that body
     * (1, else 0), its triangle, what part of the radiance found from here on reaches the pixel, for each channel, and
     * the radiance so far.
     */
    public static final int ORIGIN = 0;

    public static final int DIRECTION = 3;
    public static final int LEAVING = 6;
    public static final int INSIDE = 7;

    /** The triangle of the body that the ray leaves, where that is a mesh. */
    public static final int LEAVING_TRIANGLE = 8;

    public static final int THROUGHPUT = 9;
    public static final int RADIANCE = 12;

    /** Column and row of the pixel in the whole picture, and where in {@code pixelSamples} its sample is. */
    public static final int PIXEL_COLUMN = 15;

    public static final int PIXEL_ROW = 16;
    public static final int PIXEL_SAMPLE = 17;

    /** What the ray meets: how far away, where, which way the surface faces, and what it is made of. */
    public static final int DISTANCE = 18;

    public static final int POINT = 19;
    public static final int NORMAL = 22;
    public static final int ALBEDO = 25;
    public static final int REFLECTIVITY = 28;

    /** The light's center, seen from the point: a unit vector, the distance, and the cosine against the normal. */
    public static final int TO_LIGHT = 29;

    public static final int LIGHT_DISTANCE = 32;
    public static final int NORMAL_DOT_LIGHT = 33;

    /**
     * The axes U (its x is 0) and W of the light's disc, and tangent and secant of its half angle as the point sees it.
     */
    public static final int DISC_U_Y = 34;

    public static final int DISC_U_Z = 35;
    public static final int DISC_W = 36;
    public static final int DISC_TANGENT = 39;
    public static final int DISC_SECANT = 40;

    /** How long the path is where all materials are {@link Material#PLAIN}, and nothing is counted. */
    public static final int PLAIN_PATH_LENGTH = 41;

    /** Whether the ray comes from inside the body (1, else 0), and the rest of what it is made of. */
    public static final int FROM_INSIDE = 41;

    public static final int ROUGHNESS = 42;
    public static final int TRANSMISSION = 43;
    public static final int IOR = 44;

    /** The normal of the surface's facet that reflects and refracts, turned against the ray. */
    public static final int FACET = 45;

    /** What {@link Aspect} counts, of all samples together. */
    public static final int COUNT = 48;

    /** Which instance and which of its triangles the ray meets. */
    public static final int INSTANCE = 49;

    public static final int TRIANGLE = 50;

    /** The unit normal of the triangle's face, on the side from which its corners turn to the left. */
    public static final int FACE = 51;

    /** The point's place in the mesh's texture: u, v. */
    public static final int TEXTURE_PLACE = 54;

    public static final int PATH_LENGTH = 56;

    /** The largest reflectivity, at which a body is a perfect mirror. */
    public static final float MAX_REFLECTIVITY = 128f;

    private Layout() {}

    /** How long the spheres' part of the hierarchy is, for a number of bodies without meshes. */
    public static int spheresLength(int room) {
        int spheres = room - FIRST_SPHERE;
        return root(room) + NODE_STRIDE * (spheres > 0 ? 2 * spheres - 1 : 1);
    }

    /** Where in the hierarchy the meshes' part begins. */
    static int instances(int firstMesh) {
        return spheresLength(firstMesh);
    }

    /** Where the root is in the hierarchy of a scene of that number of bodies: after the spheres. */
    public static int root(int bodies) {
        return SPHERE_STRIDE * (bodies - FIRST_SPHERE);
    }
}
