package dev.twister.engine.vector.lanes;

import dev.twister.engine.vector.frame.PaddedSky;
import dev.twister.kernel.Layout;

/**
 * 16 x 16 pixels on their way, as one thread draws them: columns of {@value #SIZE} floats, one value a pixel, in one
 * array so that one bounds check covers neighboring columns.
 *
 * <p>Pixels lie in blocks of 4 x 4, row by row within a block and block by block within the tile, so that a packet of
 * 16 lanes is 4 x 4 pixels, one of 8 is 4 x 2, and one of 4 is 4 x 1: rays close together take the same way.
 */
public final class Tile {
    /** Pixels along each side. */
    public static final int SIDE = 16;

    public static final int SIZE = SIDE * SIDE;

    private static final int PACKETS = SIZE / Lanes.COUNT;

    /** Pixels along a block's side. */
    public static final int BLOCK_SIDE = 4;

    public static final int BLOCK = BLOCK_SIDE * BLOCK_SIDE;

    /** The ray: a unit vector, and where it starts. */
    public static final int DIRECTION_X = Lanes.BORDER;

    public static final int DIRECTION_Y = DIRECTION_X + SIZE;
    public static final int DIRECTION_Z = DIRECTION_X + 2 * SIZE;
    public static final int ORIGIN_X = DIRECTION_X + 3 * SIZE;
    public static final int ORIGIN_Y = DIRECTION_X + 4 * SIZE;
    public static final int ORIGIN_Z = DIRECTION_X + 5 * SIZE;

    /** Meters along the ray to what it meets. */
    public static final int DISTANCE = DIRECTION_X + 6 * SIZE;

    /** The body met, as a float (exact far beyond any scene): {@link Layout}'s numbers, or {@link #ENDED}. */
    public static final int HIT = DIRECTION_X + 7 * SIZE;

    /** What part of the light found from here on reaches the pixel; 0 once the path has ended. */
    public static final int THROUGHPUT = DIRECTION_X + 8 * SIZE;

    public static final int RED = DIRECTION_X + 9 * SIZE;
    public static final int GREEN = DIRECTION_X + 10 * SIZE;
    public static final int BLUE = DIRECTION_X + 11 * SIZE;

    /** The point met. */
    public static final int POINT_X = DIRECTION_X + 12 * SIZE;

    public static final int POINT_Y = DIRECTION_X + 13 * SIZE;
    public static final int POINT_Z = DIRECTION_X + 14 * SIZE;

    /**
     * The surface met, from the normal to the reflectivity; at first a body's {@code BodyColumns.surfaces}, in their
     * order.
     */
    public static final int SURFACE = DIRECTION_X + 15 * SIZE;

    public static final int NORMAL_X = SURFACE;
    public static final int NORMAL_Y = DIRECTION_X + 16 * SIZE;
    public static final int NORMAL_Z = DIRECTION_X + 17 * SIZE;
    public static final int RADIUS = DIRECTION_X + 18 * SIZE;
    public static final int ALBEDO_RED = DIRECTION_X + 19 * SIZE;
    public static final int ALBEDO_GREEN = DIRECTION_X + 20 * SIZE;
    public static final int ALBEDO_BLUE = DIRECTION_X + 21 * SIZE;
    public static final int REFLECTIVITY = DIRECTION_X + 22 * SIZE;

    /** The light, seen from the surface: a unit vector, meters. */
    public static final int TO_LIGHT_X = DIRECTION_X + 23 * SIZE;

    public static final int TO_LIGHT_Y = DIRECTION_X + 24 * SIZE;
    public static final int TO_LIGHT_Z = DIRECTION_X + 25 * SIZE;
    public static final int LIGHT_DISTANCE = DIRECTION_X + 26 * SIZE;
    public static final int NORMAL_DOT_LIGHT = DIRECTION_X + 27 * SIZE;

    /** The point met, seen from its sphere's center; needed only until the light's direction is. */
    public static final int FROM_CENTER_X = TO_LIGHT_X;

    public static final int FROM_CENTER_Y = TO_LIGHT_Y;
    public static final int FROM_CENTER_Z = TO_LIGHT_Z;

    /** S, the visible part of the light. */
    public static final int VISIBLE = DIRECTION_X + 28 * SIZE;

    /** 1 where S is not yet known, else 0. */
    public static final int SHADOW_OPEN = DIRECTION_X + 29 * SIZE;

    public static final int SPECULAR = DIRECTION_X + 30 * SIZE;

    /** The sky's angles in radians, then columns and rows in texels, then fractions of a texel. */
    public static final int SKY_TO_RIGHT = DIRECTION_X + 31 * SIZE;

    public static final int SKY_TO_BOTTOM = DIRECTION_X + 32 * SIZE;

    /** The body that the ray leaves. */
    public static final int LEAVING = DIRECTION_X + 33 * SIZE;

    /** Tangent and secant of the half angle of the light's disc, as seen from the surface. */
    public static final int DISC_TANGENT = DIRECTION_X + 34 * SIZE;

    public static final int DISC_SECANT = DIRECTION_X + 35 * SIZE;

    /** A cosine to a reflectivity's fraction. */
    public static final int FRACTION_POWER = DIRECTION_X + 36 * SIZE;

    /** What a cosine's power is multiplied by. */
    public static final int SPECULAR_WEIGHT = DIRECTION_X + 37 * SIZE;

    /** 1 where a packet's rays are walked with as one, else 0. */
    public static final int TOGETHER = DIRECTION_X + 38 * SIZE;

    /** Each pixel's place in the tile, from its left and top. */
    public static final int PLACE_X = DIRECTION_X + 39 * SIZE;

    public static final int PLACE_Y = DIRECTION_X + 40 * SIZE;

    /**
     * What the surface is made of beyond color and reflectivity, in frames with any such body: in the order of a body's
     * looks.
     */
    public static final int ROUGHNESS = DIRECTION_X + 41 * SIZE;

    public static final int TRANSMISSION = DIRECTION_X + 42 * SIZE;
    public static final int IOR = DIRECTION_X + 43 * SIZE;
    public static final int TEXTURE = DIRECTION_X + 44 * SIZE;

    /** The size of the texture in texels. */
    public static final int TEXTURE_WIDTH = DIRECTION_X + 45 * SIZE;

    public static final int TEXTURE_HEIGHT = DIRECTION_X + 46 * SIZE;

    /** The normal of the surface's facet that reflects, turned against the ray. */
    public static final int FACET_X = DIRECTION_X + 47 * SIZE;

    public static final int FACET_Y = DIRECTION_X + 48 * SIZE;
    public static final int FACET_Z = DIRECTION_X + 49 * SIZE;

    /** Two numbers in [0, 1) that a rough surface's facet is tilted by. */
    public static final int FIRST_NUMBER = SKY_TO_RIGHT;

    public static final int SECOND_NUMBER = SKY_TO_BOTTOM;

    /**
     * 1 where the ray goes on inside the body that it leaves, and where it comes from inside the one that it meets;
     * else 0.
     */
    public static final int INSIDE = DIRECTION_X + 50 * SIZE;

    public static final int FROM_INSIDE = DIRECTION_X + 51 * SIZE;

    /** The throughput before the surface. */
    public static final int WHOLE = DIRECTION_X + 52 * SIZE;

    /** What the body's color lets pass, while the albedo is that of what it does not transmit. */
    public static final int PASSED_RED = DIRECTION_X + 53 * SIZE;

    public static final int PASSED_GREEN = DIRECTION_X + 54 * SIZE;
    public static final int PASSED_BLUE = DIRECTION_X + 55 * SIZE;

    /** What the colors found are to be multiplied by, in a tile of rays that waited; 1 in others. */
    public static final int TINT_RED = DIRECTION_X + 56 * SIZE;

    public static final int TINT_GREEN = DIRECTION_X + 57 * SIZE;
    public static final int TINT_BLUE = DIRECTION_X + 58 * SIZE;

    /** The number of the pixel that the ray is drawn for. */
    public static final int PIXEL = DIRECTION_X + 59 * SIZE;

    /** The refracted ray, and what part of the throughput it takes; needed only once the surface is shaded. */
    public static final int REFRACTED_X = TO_LIGHT_X;

    public static final int REFRACTED_Y = TO_LIGHT_Y;
    public static final int REFRACTED_Z = TO_LIGHT_Z;
    public static final int REFRACTED_PART = SPECULAR;

    /** The tint of a ray that goes on, and whether it does so inside. */
    public static final int NEXT_RED = FACET_X;

    public static final int NEXT_GREEN = FACET_Y;
    public static final int NEXT_BLUE = FACET_Z;
    public static final int NEXT_INSIDE = VISIBLE;

    /**
     * Of a sphere's center, how far along the ray, the square of half the chord, and of its distance; until points are
     * known.
     */
    public static final int SPHERE_ALONG = POINT_X;

    public static final int SPHERE_CHORD = POINT_Y;
    public static final int SPHERE_AWAY = POINT_Z;

    /** A rough surface's facet, in its tangents' frame; needed only until the facet is known. */
    public static final int LOCAL_X = TO_LIGHT_X;

    public static final int LOCAL_Y = TO_LIGHT_Y;
    public static final int LOCAL_Z = TO_LIGHT_Z;

    /** The triangle of the body that the ray leaves, where that is a mesh. */
    public static final int LEAVING_TRIANGLE = DIRECTION_X + 60 * SIZE;

    /** Which instance and which of its triangles the ray meets, and the face's normal, where it meets a mesh. */
    public static final int INSTANCE = DIRECTION_X + 61 * SIZE;

    public static final int TRIANGLE = DIRECTION_X + 62 * SIZE;
    public static final int FACE_X = DIRECTION_X + 63 * SIZE;
    public static final int FACE_Y = DIRECTION_X + 64 * SIZE;
    public static final int FACE_Z = DIRECTION_X + 65 * SIZE;

    /** How many samples of the light meshes hide, in packets of {@link #meshShadows}. */
    public static final int MESH_BLOCKED = DIRECTION_X + 66 * SIZE;

    private static final int COLUMNS = 67;

    /** Columns of {@link #corners}. */
    public static final int UPPER_LEFT = Lanes.BORDER;

    public static final int UPPER_RIGHT = UPPER_LEFT + SIZE;
    public static final int LOWER_LEFT = UPPER_LEFT + 2 * SIZE;
    public static final int LOWER_RIGHT = UPPER_LEFT + 3 * SIZE;
    public static final int CORNERS = 4;

    /** The hit of a lane whose path ended before. */
    public static final float ENDED = -2f;

    /** The columns above, from {@link Lanes#BORDER} on. */
    public final float[] values = new float[DIRECTION_X + COLUMNS * SIZE];

    /** From the padded sky's start to the upper left texel, in texels. */
    public final int[] texels = new int[SIZE];

    /** Every pixel's number. */
    public final int[] pixels = new int[SIZE];

    /** The pixels that go a way of their own: to the sky, to what they meet of a crowd, or to the light. */
    public final PixelList lonely = new PixelList(SIZE);

    /** Of the spheres that are copied next, where they begin in {@code BodyColumns.surfaces}. */
    public final int[] surfacePlaces = new int[SIZE];

    /** The sum of what was read for nothing but to have it in the caches; kept, as the compiler would leave it out. */
    public float readAhead;

    /** The four texels about each pixel's direction, as {@link PaddedSky#shared} has them, in columns. */
    public final int[] corners = new int[Lanes.BORDER + CORNERS * SIZE];

    /** The same as numbers: all red ones, all green ones, all blue ones. */
    public final float[] cornerNumbers = new float[Lanes.BORDER + PaddedSky.NUMBERS_A_TEXEL * CORNERS * SIZE];

    /** The finished pixels, from {@link Lanes#BORDER} on. */
    public final int[] argb = new int[Lanes.BORDER + SIZE];

    /** Packets, by the place of their first pixel: those whose paths go on, and those that met the sky, and so on. */
    public final PacketList live = new PacketList(PACKETS);

    public final PacketList skies = new PacketList(PACKETS);
    public final PatchList skyPatches = new PatchList(PACKETS);
    public final PacketList scatteredSkies = new PacketList(PACKETS);
    public final PacketList lights = new PacketList(PACKETS);
    public final PacketList grounds = new PacketList(PACKETS);
    public final PacketList spheres = new PacketList(PACKETS);
    public final PacketList surfaces = new PacketList(PACKETS);
    public final PacketList shadows = new PacketList(PACKETS);

    /** Those of the spheres that met meshes. */
    public final PacketList meshes = new PacketList(PACKETS);

    /** Those from which meshes hide a part of the light. */
    public final PacketList meshShadows = new PacketList(PACKETS);

    /** Those whose surfaces have a texture. */
    public final PacketList textures = new PacketList(PACKETS);

    /** Those with a rough surface. */
    public final PacketList rough = new PacketList(PACKETS);

    /** Those with a surface that transmits. */
    public final PacketList transparent = new PacketList(PACKETS);

    /** Those with rays {@link #TOGETHER}. */
    public final PacketList together = new PacketList(PACKETS);

    /** Those where anything shines: all that does to one whole power, to whole powers, and to any. */
    public final PacketList onePower = new PacketList(PACKETS);

    public final PacketList wholePowers = new PacketList(PACKETS);
    public final PacketList fractionPowers = new PacketList(PACKETS);

    /** Of a packet in {@link #onePower}, by the packet's number. */
    public final float[] powers = new float[SIZE / Lanes.COUNT];

    /** The bodies that the live rays may meet. */
    public final BodyList candidates = new BodyList();

    /** Of those, the ones that transmit, once they are told apart. */
    public final BodyList transmitting = new BodyList();

    /** Whether the live rays may meet a mesh. Those that do count as having met a sphere. */
    public boolean nearMeshes;

    /** The first pixel's place in the frame. */
    public int left;

    public int top;

    /** Which of the pixels' samples is drawn. */
    public int sample;

    /** How many rays there are in a tile of rays that waited. */
    public int rays;

    /** Whether no ray goes on from here. */
    public boolean last;

    public Tile() {
        for (int pixel = 0; pixel < SIZE; pixel++) {
            values[PLACE_X + pixel] = column(pixel);
            values[PLACE_Y + pixel] = row(pixel);
            values[TINT_RED + pixel] = 1f;
            values[TINT_GREEN + pixel] = 1f;
            values[TINT_BLUE + pixel] = 1f;
            values[PIXEL + pixel] = pixel;
            pixels[pixel] = pixel;
        }
    }

    /** To another tile's place. */
    public void moveTo(Tile other) {
        left = other.left;
        top = other.top;
    }

    /** In [0, {@link #SIDE}), of a pixel in the tile's order. */
    public static int column(int pixel) {
        int block = pixel / BLOCK;
        return block % (SIDE / BLOCK_SIDE) * BLOCK_SIDE + pixel % BLOCK_SIDE;
    }

    /** In [0, {@link #SIDE}), of a pixel in the tile's order. */
    public static int row(int pixel) {
        int block = pixel / BLOCK;
        return block / (SIDE / BLOCK_SIDE) * BLOCK_SIDE + pixel % BLOCK / BLOCK_SIDE;
    }
}
