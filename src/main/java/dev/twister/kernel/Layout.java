package dev.twister.kernel;

/** Layout of the kernel's arrays; nothing else defines it. */
public final class Layout {
    /**
     * {@code float[] frame}, what may change with each frame; counts and places are integers that a float holds
     * exactly. First the camera: position; unit vectors right, up and forward; eye distance; lens.
     */
    public static final int CAMERA_POSITION = 0;

    public static final int CAMERA_RIGHT = 3;
    public static final int CAMERA_UP = 6;
    public static final int CAMERA_FORWARD = 9;

    /** {@code 1 / tan(fov / 2)}: distance of the eye behind the viewport, whose shorter half side is 1. */
    public static final int CAMERA_EYE_DISTANCE = 12;

    /** The lens's radius in meters; 0 for a pinhole. */
    public static final int CAMERA_APERTURE = 13;

    /** Distance of the plane in focus, in meters. */
    public static final int CAMERA_FOCUS = 14;

    /** The projection's number in {@link CameraRay}. */
    public static final int CAMERA_PROJECTION = 15;

    /** For the orthographic projection: meters that the picture's height shows. */
    public static final int CAMERA_VIEW_HEIGHT = 16;

    /** For the fisheye projection: half the angle over the shorter side, in turns. */
    public static final int CAMERA_HALF_FIELD = 17;

    public static final int CAMERA_LENGTH = 18;

    public static final int SHADOW_SAMPLES = 18;
    public static final int BOUNCES = 19;
    public static final int PIXEL_SAMPLES = 20;

    /** 2^exposure. */
    public static final int EXPOSURE_SCALE = 21;

    /** A tone map's number in {@link Tone}. */
    public static final int TONE_MAP = 22;

    /** 1 if the sRGB transfer function follows the tone map, else 0. */
    public static final int SRGB = 23;

    public static final int AMBIENT = 24;

    /** The plane's second color (three floats); its first is the body's own. */
    public static final int PLANE_ODD_COLOR = 25;

    /** Rotation of the panorama to the right, in turns, in [0, 1). */
    public static final int SKY_TURN = 28;

    /** Factor for the panorama's radiance, at least 0. */
    public static final int SKY_STRENGTH = 29;

    /** The panorama's width and height in texels. */
    public static final int SKY_WIDTH = 30;

    public static final int SKY_HEIGHT = 31;

    /** Width and height of the whole picture in pixels, and the range of rows to render. */
    public static final int WIDTH = 32;

    public static final int HEIGHT = 33;
    public static final int FIRST_ROW = 34;
    public static final int ROWS = 35;

    /** Number of present bodies without meshes: the first light, the plane and the spheres. */
    public static final int BODIES = 36;

    /**
     * The first mesh's body; it is 0 if there are no meshes. Meshes are numbered after all spheres: those not poured
     * yet, and the lights after the first, come between them.
     */
    public static final int FIRST_MESH = 37;

    /** Place in {@code bodies} of the root over all spheres. */
    public static final int ROOT = 38;

    /** Place of the meshes' hierarchy in {@code bodies}. */
    public static final int INSTANCES = 39;

    /** Place of the maps' table in {@code looks}. */
    public static final int MAPS = 40;

    /** For path tracing: limit of the luminance of what reaches the eye over several surfaces; 0 for none. */
    public static final int CLAMP = 41;

    /** Place of the table of emitters in {@code looks}, their number, and the sky's, from 1 on, or 0. */
    public static final int EMITTER_TABLE = 42;

    public static final int EMITTERS = 43;
    public static final int SKY_EMITTER = 44;

    /** Place of the sky's table of probabilities in {@code images}, divided by {@value #ALIGNMENT}. */
    public static final int SKY_TABLE = 45;

    /** Number of lights, and place in {@code looks} of the table of their bodies. */
    public static final int LIGHTS = 46;

    public static final int LIGHT_TABLE = 47;

    /** Place in {@code bodies} of the root over the spheres that cast shadows, which lights do not. */
    public static final int SHADOW_ROOT = 48;

    /** Place in {@code looks} of the tree over the emitters but suns and sky ({@link LightTree}); 0 without one. */
    public static final int LIGHT_TREE = 49;

    /** Number of the first of the pixel's samples in the infinite sequence. */
    public static final int FIRST_SAMPLE = 50;

    /**
     * Place in {@code frame} of the tiles to render: for each square of {@value #TILE_SIDE} x {@value #TILE_SIDE}
     * pixels of the rows, from the top left, 1 if it is to be rendered, else 0. 0 if all are.
     */
    public static final int TILES = 51;

    public static final int TILE_SIDE = 16;

    /** Largest number of tiles that can be chosen from. */
    public static final int MOST_TILES = 4096;

    /** With {@link LightLayers}: their number, and the place of the bodies' groups in {@code looks}. */
    public static final int LIGHT_LAYERS = 52;

    public static final int LIGHT_GROUPS = 53;

    /** The body that the camera is in, and the one around that ({@link Medium}); {@link #NOTHING} for none. */
    public static final int CAMERA_MEDIUM = 54;

    public static final int CAMERA_OUTER_MEDIUM = 55;

    /** Number of suns, whose emitters are the last ones but the sky's. */
    public static final int SUNS = 56;

    /** Place of the pixel's samples in {@code frame}. */
    public static final int SAMPLES = 57;

    /**
     * The points of the unit sunflower, x and y of each shadow sample; then, at {@link #SAMPLES}, the pixel's samples.
     */
    public static final int DISC = 58;

    /**
     * A sample of the pixel, {@value #SAMPLE_STRIDE} floats: its position in the pixel, x and y in (0, 1); then pairs
     * of numbers in [0, 1), one pair for the lens and one for the surface of each of the first
     * {@value #SAMPLE_SURFACES} bounces; {@link Noise} has more for later ones.
     */
    public static final int SAMPLE_LENS = 2;

    public static final int SAMPLE_SURFACE = 4;
    public static final int SAMPLE_SURFACES = 6;
    public static final int SAMPLE_STRIDE = SAMPLE_SURFACE + 2 * SAMPLE_SURFACES;

    /** The largest number of bounces. */
    public static final int MOST_BOUNCES = 64;

    /** Numbers of bodies; the first light's, which is nowhere if that is a sun. */
    public static final int LIGHT = 0;

    public static final int PLANE = 1;
    public static final int FIRST_SPHERE = 2;

    /** Number of a miss instead of a body. */
    public static final int NOTHING = -1;

    /** Value of {@link #FIRST_MESH} if there are no meshes. */
    public static final int NO_MESHES = 0;

    /**
     * {@code float[] bodies}, what changes when bodies move. First, for each body, {@value #PLACE_STRIDE} floats: the
     * center, then a sphere's radius or the plane's side. A mesh has its bounding sphere.
     */
    public static final int PLACE_SIZE = 3;

    public static final int PLACE_STRIDE = 4;

    /** {@code float[] looks}, {@value #LOOK_STRIDE} floats per body: the color, then the material. */
    public static final int LOOK_REFLECTIVITY = 3;

    /** In [0, 1]; 0 if the body neither reflects nor transmits. */
    public static final int LOOK_ROUGHNESS = 4;

    /** In [0, 1]. */
    public static final int LOOK_TRANSMISSION = 5;

    /** Index of refraction in [1, 4]; 0 without transmission. */
    public static final int LOOK_IOR = 6;

    /** Number of the body's row in the maps' table, from 1 on; 0 for none. */
    public static final int LOOK_MAPS = 7;

    /** How much of a metal the body is, in [0, 1]. */
    public static final int LOOK_METALLIC = 8;

    /** {@link #IS_FRESNEL} of the body. */
    public static final int LOOK_FRESNEL = 9;

    /** Emitted radiance, three floats; a light has one in path tracing alone. */
    public static final int LOOK_EMISSION = 10;

    /** Number of the body's first emitter, from 1 on; 0 without one. */
    public static final int LOOK_EMITTER = 13;

    /** 1 if only the outer sides of the body's triangles emit, else 0. */
    public static final int LOOK_ONE_SIDED = 14;

    /** Absorption inside a transmitting body, per meter and channel. */
    public static final int LOOK_ABSORPTION = 15;

    /** A light's factor of what it adds to the brightness of matte surfaces; 0 for other bodies. */
    public static final int LOOK_SHARE = 18;

    /** What kind of light the body is; 0 for none. */
    public static final int LOOK_LIGHT = 19;

    /** A light that is a sphere, which is drawn in its own color. */
    public static final int SPHERE_LIGHT = 1;

    /**
     * A sun, which no ray hits. Its place is a vector toward it that is longer than any shadow ray need be; its size,
     * divided by that length, is {@link #LOOK_SUN_SINE}.
     */
    public static final int SUN_LIGHT = 2;

    /** A sphere that shines in a cone of directions, and that rays outside of it pass ({@link SpotEmitter}). */
    public static final int SPOT_LIGHT = 3;

    /** The reflectivity beside a metal, for path tracing. */
    public static final int LOOK_BESIDE_METAL = 20;

    /** What is missing of the dielectric reflectance in path tracing, in [0, 1]. */
    public static final int LOOK_SPECULAR_LOSS = 21;

    /** A spot's axis, or a sun's: the unit vector in which it shines. */
    public static final int LOOK_SPOT_AXIS = 22;

    /** Factor and summand that make the cosine of the angle with the axis the root of the part that a spot shines. */
    public static final int LOOK_SPOT_SCALE = 25;

    public static final int LOOK_SPOT_OFFSET = 26;

    /** The sine of the angle that the radius of a sun's disc fills. */
    public static final int LOOK_SUN_SINE = 27;

    /** Place in {@code looks} of the tables of {@link DirectionalAlbedo}, where {@link #LOOK_FRESNEL} is 1. */
    public static final int LOOK_ALBEDOS = 28;

    /** {@link #SHEET_OF_BODY} if the body is as thin as a sheet, else 0. */
    public static final int LOOK_SHEET = 29;

    /** Place in {@code looks} of the body's finish, which is what path tracing alone shows; 0 without one. */
    public static final int LOOK_FINISH = 30;

    public static final int LOOK_STRIDE = 31;

    /**
     * A finish, as the extensions of glTF's material define it, which starts with what the path has at {@link #FINISH}.
     * Parts of its clear coat and of its thin film, in [0, 1]; roughnesses in [0, 1].
     */
    public static final int FINISH_COAT = 0;

    public static final int FINISH_COAT_ROUGHNESS = 1;

    /** The sheen's color, three floats, and its roughness. */
    public static final int FINISH_SHEEN = 2;

    public static final int FINISH_SHEEN_ROUGHNESS = 5;

    /** In [0, 1], and cosine and sine of the angle from the tangent to the direction of the stretched highlight. */
    public static final int FINISH_ANISOTROPY = 6;

    public static final int FINISH_GRAIN_COSINE = 7;
    public static final int FINISH_GRAIN_SINE = 8;

    /** Factor per channel of what the dielectric reflects at the normal. */
    public static final int FINISH_SPECULAR_COLOR = 9;

    /** The thin film's part, its index of refraction, and its thickness in nanometers. */
    public static final int FINISH_FILM = 12;

    public static final int FINISH_FILM_IOR = 13;
    public static final int FINISH_FILM_THICKNESS = 14;

    /** 20 divided by the Abbe number; 0 for none. */
    public static final int FINISH_DISPERSION = 15;

    /** The part of the matte light that passes the surface, in [0, 1], and its color. */
    public static final int FINISH_THROUGH = 16;

    public static final int FINISH_THROUGH_COLOR = 17;

    /** Number of floats that the path has at {@link #FINISH}. */
    public static final int FINISH_LENGTH = 20;

    /** The film's thickness in nanometers where its map is 0. */
    public static final int FINISH_FILM_LEAST = 20;

    /** Places in {@code looks} of the tables of {@link DirectionalAlbedo} of the clear coat, and of the sheen's. */
    public static final int FINISH_COAT_ALBEDO = 21;

    public static final int FINISH_SHEEN_ALBEDO = 22;

    /** Factor of the x and y of the clear coat's normal map. */
    public static final int FINISH_COAT_NORMAL_SCALE = 23;

    /**
     * The maps of a finish, each as in the maps' table: of the clear coat (red), its roughness (green) and its normals;
     * of the sheen's color and roughness (red); of the anisotropy (red and green the direction, blue the strength); of
     * the specular factor (red) and color; of the film (red) and its thickness (green); of the part that passes (red)
     * and its color.
     */
    public static final int FINISH_MAPS_COAT = 24;

    public static final int FINISH_MAPS_COAT_ROUGHNESS = 28;
    public static final int FINISH_MAPS_COAT_NORMAL = 32;
    public static final int FINISH_MAPS_SHEEN = 36;
    public static final int FINISH_MAPS_SHEEN_ROUGHNESS = 40;
    public static final int FINISH_MAPS_ANISOTROPY = 44;
    public static final int FINISH_MAPS_SPECULAR = 48;
    public static final int FINISH_MAPS_SPECULAR_COLOR = 52;
    public static final int FINISH_MAPS_FILM = 56;
    public static final int FINISH_MAPS_FILM_THICKNESS = 60;
    public static final int FINISH_MAPS_THROUGH = 64;
    public static final int FINISH_MAPS_THROUGH_COLOR = 68;
    public static final int FINISH_STRIDE = 72;

    /**
     * After the bodies' looks, from {@link #MAPS} on, a table of the materials with maps. A row has first the maps. A
     * map is the place of its first texel in {@code images}, divided by {@value #ALIGNMENT}, so that it is exact as a
     * float; its width and height in texels, 0 if there is no such map; and how it is read: the sum of what is beyond
     * its borders across and, times {@value #SAMPLER_DOWN}, down (a constant of {@link Texture}),
     * {@value #SAMPLER_NEAREST} for the nearest texel instead of bilinear ones, {@value #SAMPLER_PACKED} for packed
     * texels, and {@value #SAMPLER_COORDINATES} times the number of the mesh's texture coordinates.
     */
    public static final int MAP_START = 0;

    public static final int MAP_WIDTH = 1;
    public static final int MAP_HEIGHT = 2;
    public static final int MAP_SAMPLER = 3;
    public static final int MAP_STRIDE = 4;
    public static final int SAMPLER_DOWN = 3;
    public static final int SAMPLER_NEAREST = 9;
    public static final int SAMPLER_PACKED = 18;
    public static final int SAMPLER_COORDINATES = 36;

    /** The maps that multiply color and emission, roughness (green) and metallic (blue). */
    public static final int MAPS_COLOR = 0;

    public static final int MAPS_EMISSION = 4;
    public static final int MAPS_ROUGHNESS = 8;
    public static final int MAPS_METALLIC = 12;

    /** Normals in tangent space, x and y right and up on the image, from -1 at 0 to 1 at 1. */
    public static final int MAPS_NORMAL = 16;

    /** Maps that multiply the ambient light (red) and the transmission (red). */
    public static final int MAPS_OCCLUSION = 20;

    public static final int MAPS_TRANSMISSION = 24;

    /** Opacity; its texels, one float each, are in {@code meshes}. */
    public static final int MAPS_ALPHA = 28;

    /** Factor of the normals' x and y, and how much the occlusion map counts, in [0, 1]. */
    public static final int MAPS_NORMAL_SCALE = 32;

    public static final int MAPS_OCCLUSION_STRENGTH = 33;

    /** What multiplies the opacity; the mask's cutoff, or {@link #BLENDED} or {@link #OPAQUE}. */
    public static final int MAPS_ALPHA_FACTOR = 34;

    public static final int MAPS_CUTOFF = 35;
    public static final int BLENDED = -1;
    public static final int OPAQUE = -2;

    /** 1 if colors of the mesh's vertices multiply color and opacity, else 0. */
    public static final int MAPS_VERTEX_COLORS = 36;

    /** 1 if the color shows as it is, without light, else 0. */
    public static final int MAPS_UNLIT = 37;

    public static final int MAPS_STRIDE = 38;

    /**
     * After the maps' table, from {@link #EMITTER_TABLE} on, the emitters of path tracing, each with the sum of the
     * probabilities up to and including its own, its probability, its body ({@link #NOTHING} for the sky), for a
     * triangle its instance, its number (else -1) and its area in square meters, and the number of its leaf in the
     * tree. The suns come before the sky, which is the last.
     */
    public static final int EMITTER_END = 0;

    public static final int EMITTER_PROBABILITY = 1;
    public static final int EMITTER_BODY = 2;
    public static final int EMITTER_INSTANCE = 3;
    public static final int EMITTER_TRIANGLE = 4;
    public static final int EMITTER_AREA = 5;
    public static final int EMITTER_LEAF = 6;
    public static final int EMITTER_STRIDE = 7;

    /**
     * After the emitters, from {@link #LIGHT_TREE} on, a tree over them, the suns and the sky apart. A node with n
     * leaves has as its first child the node that follows it, with the first n / 2 of them, rounded down; after that
     * one's nodes comes the second child. A node has a sphere around its emitters, the sum of their powers, and a cone
     * that holds the directions to which they emit most: a unit axis, cosine and sine of its half angle, at most a
     * straight one.
     */
    public static final int LIGHTS_CENTER = 0;

    public static final int LIGHTS_RADIUS = 3;
    public static final int LIGHTS_POWER = 4;
    public static final int LIGHTS_AXIS = 5;
    public static final int LIGHTS_COSINE = 8;
    public static final int LIGHTS_SINE = 9;

    /** Of a leaf: the number of its emitter in the table, from 0 on. */
    public static final int LIGHTS_EMITTER = 10;

    public static final int LIGHTS_STRIDE = 11;

    /** Largest number of {@link LightLayers}. */
    public static final int MOST_LIGHT_LAYERS = 16;

    /** Meshes and maps start at multiples of it. */
    public static final int ALIGNMENT = 256;

    /**
     * {@code float[] images}, row by row from the top: the panorama, then the maps. A texel has three floats. One of a
     * packed map is a single float, red + 256 green + 65536 blue, of codes from 0 to 255; what the codes stand for is
     * in the {@value #CODES} floats before the map's first texel.
     */
    public static final int TEXEL_STRIDE = 3;

    public static final int CODES = 256;

    /**
     * In {@code bodies}, after the places, a bounding volume hierarchy over the spheres: first the spheres, contiguous
     * per leaf, then the nodes, the root first, at {@link #ROOT}. A sphere has its center and radius as in the places,
     * then its body number. Lights after the first are spheres: with them, the root's first child is at
     * {@link #SHADOW_ROOT}, over the other spheres, and its second is over these lights.
     */
    public static final int SPHERE_RADIUS = PLACE_SIZE;

    public static final int SPHERE_BODY = 4;

    /** Distance between spheres. */
    public static final int SPHERE_STRIDE = 5;

    /** A node's box: its center, and half its sides. */
    public static final int NODE_CENTER = 0;

    public static final int NODE_HALF = 3;

    /**
     * Place in {@code bodies} of a leaf's first sphere, or of a node's first child; the second child follows the first.
     */
    public static final int NODE_LINK = 6;

    /** Number of spheres (or triangles) in a leaf; negative for a node with children. */
    public static final int NODE_SPHERES = 7;

    /** Distance between nodes. */
    public static final int NODE_STRIDE = 8;

    /**
     * After the spheres' hierarchy, at {@link #INSTANCES}: the length of nodes and small meshes divided by
     * {@value #NODE_STRIDE}; the nodes over the meshes, the root first; the small meshes; then the instances of
     * {@code meshes}. Links are numbers of nodes and instances. A leaf's {@link #NODE_SPHERES} are 0, or the number of
     * triangles of a small mesh, whose place after the root's is the link. An instance starts with three rows of three
     * coefficients and an offset that transform a point of the world to the mesh's coordinates, then three rows for the
     * inverse.
     */
    public static final int INSTANCE_TO_MESH = 0;

    public static final int INSTANCE_TO_WORLD = 12;

    /** The instance's body number. */
    public static final int INSTANCE_BODY = 24;

    /** Start of the mesh in {@code meshes}, divided by {@value #ALIGNMENT}. */
    public static final int INSTANCE_MESH = 25;

    /** The mesh's numbers of nodes, triangles, vertex normals and texture coordinates. */
    public static final int INSTANCE_NODES = 26;

    public static final int INSTANCE_TRIANGLES = 27;
    public static final int INSTANCE_NORMALS = 28;
    public static final int INSTANCE_TEXTURE_PLACES = 29;

    /** The mesh's numbers of vertices, vertex colors and tangents. */
    public static final int INSTANCE_VERTICES = 30;

    public static final int INSTANCE_COLORS = 31;
    public static final int INSTANCE_TANGENTS = 32;
    public static final int INSTANCE_STRIDE = 33;

    /**
     * A small mesh has the triangles of an instance in the world's coordinates, if that is opaque and its mesh has one
     * leaf. It starts with the instance's number, and the largest sum of magnitudes that was rounded when a corner was
     * transformed.
     */
    public static final int SMALL_INSTANCE = 0;

    public static final int SMALL_REACH = 1;

    /** Place of its triangles, which are those of the mesh without vertex numbers. */
    public static final int SMALL_TRIANGLES = 2;

    /**
     * {@code float[] meshes}, all distinct meshes. A mesh has nodes as above, the root first, with numbers of nodes and
     * triangles as links; then the triangles in the order of the leaves; then, if it has them, the vertices' unit
     * normals, texture coordinates (u, v; one set of all vertices after the other), colors (red, green, blue, opacity)
     * and tangents (x, y, z, and the sign of cross(normal, tangent) on the side of the image's upper border). A
     * triangle has its three corners, then their vertex numbers. Opacity maps follow the meshes.
     */
    public static final int TRIANGLE_VERTICES = 9;

    public static final int TRIANGLE_STRIDE = 12;

    /** Value for no node. */
    public static final int NO_NODE = -1;

    /** Maximum depth of a node. */
    public static final int MOST_ANCESTORS = 48;

    /**
     * Number of candidates that a shadow stores; with more, each sample traverses the hierarchy. The limit lets PoCL
     * keep the scratch arrays of 4,096 pixels on a stack of 8 MB.
     */
    public static final int MOST_CANDIDATES = 32;

    /** Floats per stored candidate: its center a, u, w in the shadow's frame, and its squared radius. */
    public static final int CANDIDATE_STRIDE = 4;

    /**
     * {@code float[] scratch}, one per thread, with two uses that take turns. While a ray looks for its hit: the
     * traversal stacks over bodies and within a mesh (two floats per level). While a shadow is found: the stored
     * candidates, then the stacks over bodies and within a mesh (one float per level).
     */
    public static final int SCRATCH_STACK = 0;

    public static final int SCRATCH_RAY_NODES = 2 * MOST_ANCESTORS;
    public static final int SCRATCH_SHADOW_STACK = CANDIDATE_STRIDE * MOST_CANDIDATES;
    public static final int SCRATCH_SHADOW_NODES = SCRATCH_SHADOW_STACK + MOST_ANCESTORS;

    /**
     * With materials of any kind the scratch continues with the transmission of each stored candidate, then the waiting
     * rays.
     */
    public static final int SCRATCH_TRANSMISSIONS = SCRATCH_SHADOW_NODES + MOST_ANCESTORS;

    public static final int SCRATCH_RAYS = SCRATCH_TRANSMISSIONS + MOST_CANDIDATES;

    /** Limit of waiting rays: the fainter of two rays is followed first, and has at most half of the throughput. */
    public static final int MOST_WAITING_RAYS = 10;

    /** A waiting ray: the first floats of its path, then the bodies that it is in. */
    public static final int RAY_LENGTH = 13;

    public static final int RAY_MEDIUM = RAY_LENGTH;
    public static final int RAY_OUTER_MEDIUM = RAY_LENGTH + 1;
    public static final int RAY_STRIDE = RAY_LENGTH + 2;

    /** Length of the scratch if all materials are plain and there are no meshes. */
    public static final int PLAIN_SCRATCH_LENGTH = SCRATCH_TRANSMISSIONS;

    public static final int SCRATCH_LENGTH = SCRATCH_RAYS + RAY_STRIDE * MOST_WAITING_RAYS;

    /** With {@link LightLayers} the scratch continues with the sums of each layer over the pixel's samples. */
    public static final int SCRATCH_LAYERS = SCRATCH_LENGTH;

    public static final int LAYERED_SCRATCH_LENGTH = SCRATCH_LAYERS + 3 * MOST_LIGHT_LAYERS;

    /**
     * {@code float[] path}, one per thread: the ray; the body that it leaves, whether it continues inside that body
     * (above 0), and that body's triangle; the throughput per channel, which is the part of the radiance found from
     * here on that reaches the pixel.
     */
    public static final int ORIGIN = 0;

    public static final int DIRECTION = 3;
    public static final int LEAVING = 6;
    public static final int INSIDE = 7;

    /**
     * Values of {@link #INSIDE} of a ray that has crossed the surface that it leaves: it meets other bodies' surfaces
     * in the same place, such as the table below a glass.
     */
    public static final float CROSSED_INTO = 2f;

    public static final float CROSSED_OUT = -1f;

    /** The triangle that the ray leaves, if the body is a mesh. */
    public static final int LEAVING_TRIANGLE = 8;

    public static final int THROUGHPUT = 9;

    /** Number of surfaces that the path has left. */
    public static final int BOUNCE = 12;

    public static final int RADIANCE = 13;

    /** Column and row of the pixel in the whole picture, and the place of its sample in {@code frame}. */
    public static final int PIXEL_COLUMN = 16;

    public static final int PIXEL_ROW = 17;
    public static final int PIXEL_SAMPLE = 18;

    /** Number of waiting rays in the scratch. */
    public static final int WAITING = 19;

    /** The closest hit: distance, point, normal and material. */
    public static final int DISTANCE = 20;

    public static final int POINT = 21;
    public static final int NORMAL = 24;
    public static final int ALBEDO = 27;
    public static final int REFLECTIVITY = 30;

    /** The light's center relative to the point: unit vector, distance, and cosine with the normal. */
    public static final int TO_LIGHT = 31;

    public static final int LIGHT_DISTANCE = 34;
    public static final int NORMAL_DOT_LIGHT = 35;

    /**
     * The axes U (with x = 0) and W of the light's disc, and tangent and secant of its half angle, seen from the point.
     */
    public static final int DISC_U_Y = 36;

    public static final int DISC_U_Z = 37;
    public static final int DISC_W = 38;
    public static final int DISC_TANGENT = 41;
    public static final int DISC_SECANT = 42;

    /** The factor from the unit disc to the plane at distance 1. */
    public static final int DISC_SCALE = 43;

    /** Length of the path if all materials are plain, there are no meshes, one light, and nothing is counted. */
    public static final int PLAIN_PATH_LENGTH = 44;

    /** Whether the ray comes from inside the body (1, else 0), and the other material properties. */
    public static final int FROM_INSIDE = 44;

    public static final int ROUGHNESS = 45;
    public static final int TRANSMISSION = 46;
    public static final int IOR = 47;

    /** Normal of the microfacet that reflects and refracts, turned toward the ray's origin. */
    public static final int FACET = 48;

    /** The count of {@link Views}, over all samples. */
    public static final int COUNT = 51;

    /** The instance that the ray hits, and its triangle. */
    public static final int INSTANCE = 52;

    public static final int TRIANGLE = 53;

    /** The triangle's unit face normal, on the side from which its corners appear counterclockwise. */
    public static final int FACE = 54;

    /** The hit point's texture coordinates u and v on the mesh. */
    public static final int TEXTURE_PLACE = 57;

    /** The ray in the coordinates of a mesh, see {@link MeshRay}: origin, direction and its dominant axis. */
    public static final int MESH_ORIGIN = 59;

    public static final int MESH_DIRECTION = 62;
    public static final int MESH_AXIS = 65;

    /** The origin along the two axes after the dominant one, and along that. */
    public static final int MESH_SHEARED = 66;

    /** The direction's components along the two other axes divided by the dominant one, and the inverse of that. */
    public static final int MESH_SHEAR = 69;

    /**
     * The largest sum of magnitudes of the terms of the origin's coordinates, on which their rounding depends; negative
     * if the ray meets a surface in which it starts.
     */
    public static final int MESH_REACH = 72;

    /**
     * How much of a metal the surface is, and what decides what it reflects in path tracing: Fresnel's equations (1),
     * the reflectivity, which a metallic part tints (0), or the reflectivity beside a metal (-1).
     */
    public static final int METALLIC = 73;

    public static final int IS_FRESNEL = 74;

    /** With several lights: the body of the one that shades, and the sum of their highlights. */
    public static final int SHADING_LIGHT = 75;

    public static final int HIGHLIGHT = 76;

    /** What multiplies light that passes the surface. */
    public static final int PASSING = 79;

    /** With {@link Variant#MAPS}: emitted radiance; what multiplies the ambient light. */
    public static final int EMISSION = 82;

    public static final int OCCLUSION = 85;

    /** Barycentric weights of the hit triangle's second and third corner. */
    public static final int CORNER_PARTS = 86;

    /** The hit point's place in a map, in texels from the first one's center. */
    public static final int TEXEL = 88;

    /** Directions of a normal map's right and upper border on the surface, of any length. */
    public static final int TANGENT = 90;

    public static final int UPWARD = 93;

    /** The body that the ray is in, and the one around that ({@link Medium}); {@link #NOTHING} for none. */
    public static final int MEDIUM = 96;

    public static final int OUTER_MEDIUM = 97;

    /**
     * Whether the surface is a thin sheet, which refracts nothing: {@link #SHEET_OF_BODY}; the plane,
     * {@link #SHEET_WITHOUT_INSIDE}; else 0.
     */
    public static final int IS_SHEET = 98;

    /** A sheet around a body, which rays can be inside of, such as a bubble's. */
    public static final float SHEET_OF_BODY = 1f;

    public static final float SHEET_WITHOUT_INSIDE = 2f;

    public static final int PATH_LENGTH = 99;

    /** For path tracing: index of refraction on the ray's side divided by that on the other side. */
    public static final int RATIO = 99;

    /** Weights of the constant reflection, of the dielectric one, of the matte part and of transmission. */
    public static final int PART_MIRROR = 100;

    public static final int PART_COAT = 101;
    public static final int PART_MATTE = 102;
    public static final int PART_GLASS = 103;

    /** Probabilities of the lobes. */
    public static final int CHOICE_MIRROR = 104;

    public static final int CHOICE_MATTE = 105;
    public static final int CHOICE_GLASS = 106;

    /** {@code f * |cos|} per channel. */
    public static final int SCATTERED = 107;

    /** Density per steradian with which the surface chose the path's ray; 0 if it had no choice. */
    public static final int SURFACE_DENSITY = 110;

    /** The next ray: its direction, and whether it is inside the body (1, else 0). */
    public static final int NEXT_DIRECTION = 111;

    public static final int NEXT_INSIDE = 114;

    /** Density per steradian of the chosen emitter's direction, its radiance, and what it adds unless blocked. */
    public static final int LIGHT_DENSITY = 115;

    public static final int EMITTED = 116;
    public static final int DIRECT = 119;

    /** Unit normal of the chosen triangle. */
    public static final int EMITTER_FACE = 122;

    /** Number of rays followed so far, if the opacity of meshes is a matter of chance. */
    public static final int RAYS = 125;

    /** Probability of the chosen emitter. */
    public static final int CHOICE = 126;

    /** With a tree of emitters: the normal of the surface that has chosen; 0 if light comes from both sides. */
    public static final int LIT_NORMAL = 127;

    /** {@link #LOOK_SPECULAR_LOSS} of the surface. */
    public static final int SPECULAR_LOSS = 130;

    /** Place of the coat's table in {@link DirectionalAlbedo}, and of the mirror's; 0 without a coat. */
    public static final int COAT_ALBEDO = 131;

    public static final int MIRROR_ALBEDO = 132;

    /** Factors of the matte part under a coat, and per channel of what a metal scatters more than once. */
    public static final int UNDER_COAT = 133;

    public static final int SCATTERED_AGAIN = 134;

    /** Their means over all directions of the other ray, which only the coat or the metal's facets take from. */
    public static final int MEAN_UNDER_COAT = 137;

    public static final int MEAN_AGAIN = 138;

    public static final int TRACED_PATH_LENGTH = 139;

    /** With {@link Coverage}: the part of the background that the pixel's samples see, as a sum. */
    public static final int UNCOVERED = TRACED_PATH_LENGTH;

    /** 1 while Whitted's tree follows the view straight on, 0 once it has ended, -n while it waits for the n-th ray. */
    public static final int SIGHT = TRACED_PATH_LENGTH + 1;

    public static final int CUT_PATH_LENGTH = TRACED_PATH_LENGTH + 2;

    /** With {@link Guides}: the sums over the pixel's samples. */
    public static final int GUIDE_ALBEDO = CUT_PATH_LENGTH;

    public static final int GUIDE_NORMAL = CUT_PATH_LENGTH + 3;

    /** What the albedo is multiplied by: the tint of the mirrors and glass so far. */
    public static final int GUIDE_TINT = CUT_PATH_LENGTH + 6;

    /** 1 while the sample's guides are looked for, 0 once they are found, -n while they wait for the n-th ray. */
    public static final int GUIDE_STATE = CUT_PATH_LENGTH + 9;

    public static final int GUIDED_PATH_LENGTH = CUT_PATH_LENGTH + 10;

    /** With {@link LightLayers}: place in the scratch of the layer of the chosen emitter. */
    public static final int EMITTER_LAYER = GUIDED_PATH_LENGTH;

    public static final int LAYERED_PATH_LENGTH = GUIDED_PATH_LENGTH + 1;

    /** With {@link Variant#FINISH}: the surface's finish, after its maps. */
    public static final int FINISH = LAYERED_PATH_LENGTH;

    /** Whether the surface has a finish: 1, else 0. */
    public static final int IS_FINISHED = FINISH + FINISH_LENGTH;

    /** Unit vector along the stretched highlight, at a right angle to the normal. */
    public static final int GRAIN = FINISH + FINISH_LENGTH + 1;

    /** Unit normal of the clear coat, turned toward the ray's origin. */
    public static final int COAT_NORMAL = FINISH + FINISH_LENGTH + 4;

    /** Part of the clear coat, and of the sheen below it, on this side of the surface; what the sheen reflects. */
    public static final int COVER_COAT = FINISH + FINISH_LENGTH + 7;

    public static final int COVER_SHEEN = FINISH + FINISH_LENGTH + 8;
    public static final int SHEEN_ALBEDO = FINISH + FINISH_LENGTH + 9;

    /** Probabilities of the clear coat, and of matte light that passes. */
    public static final int CHOICE_COAT = FINISH + FINISH_LENGTH + 10;

    public static final int CHOICE_THROUGH = FINISH + FINISH_LENGTH + 11;

    /** Factor of the facets' slopes along the grain. */
    public static final int STRETCH = FINISH + FINISH_LENGTH + 12;

    /** Whether the dielectric reflection is tinted (1, else 0), and what it leaves of each channel. */
    public static final int IS_TINTED = FINISH + FINISH_LENGTH + 13;

    public static final int UNDER_TINT = FINISH + FINISH_LENGTH + 14;

    /** Place of the sheen's tables in {@code looks}. */
    public static final int SHEEN_TABLE = FINISH + FINISH_LENGTH + 17;

    /** What {@link FinishAlbedos} finds. */
    public static final int FOUND_MIRROR = FINISH + FINISH_LENGTH + 18;

    public static final int FOUND_COAT = FINISH + FINISH_LENGTH + 19;
    public static final int FOUND_GLASS = FINISH + FINISH_LENGTH + 20;
    public static final int FOUND_COSINE = FINISH + FINISH_LENGTH + 21;

    /** The reflectance per channel of a facet of metal and of a dielectric one. */
    public static final int FACET_METAL = FINISH + FINISH_LENGTH + 22;

    public static final int FACET_DIELECTRIC = FINISH + FINISH_LENGTH + 25;

    public static final int FINISHED_PATH_LENGTH = FINISH + FINISH_LENGTH + 28;

    /** The largest reflectivity, that of a perfect mirror. */
    public static final float MAX_REFLECTIVITY = 128f;

    private Layout() {}

    /** Length of the hierarchy over that number of spheres. */
    public static int spheresLength(int spheres) {
        return SPHERE_STRIDE * spheres + NODE_STRIDE * (2 * spheres + 1);
    }
}
