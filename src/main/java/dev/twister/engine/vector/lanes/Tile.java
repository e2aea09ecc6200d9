package dev.twister.engine.vector.lanes;

import dev.twister.engine.vector.frame.PaddedSky;
import dev.twister.kernel.Layout;

/**
 * One thread's 16 x 16 pixels in progress: columns of {@value #SIZE} floats, one per pixel, in one array so that one
 * bounds check covers adjacent columns.
 *
 * <p>Pixels are stored in blocks of 4 x 4, row by row within a block and block by block within the tile. A packet of 16
 * lanes is 4 x 4 pixels, one of 8 is 4 x 2, and one of 4 is 4 x 1, so its rays are coherent.
 */
public final class Tile {
    /** Pixels along each side. */
    public static final int SIDE = 16;

    public static final int SIZE = SIDE * SIDE;

    private static final int PACKETS = SIZE / Lanes.COUNT;

    /** Pixels along a block's side. */
    public static final int BLOCK_SIDE = 4;

    public static final int BLOCK = BLOCK_SIDE * BLOCK_SIDE;

    /** The ray: unit direction and origin. */
    public static final int DIRECTION_X = Lanes.BORDER;

    public static final int DIRECTION_Y = DIRECTION_X + SIZE;
    public static final int DIRECTION_Z = DIRECTION_X + 2 * SIZE;
    public static final int ORIGIN_X = DIRECTION_X + 3 * SIZE;
    public static final int ORIGIN_Y = DIRECTION_X + 4 * SIZE;
    public static final int ORIGIN_Z = DIRECTION_X + 5 * SIZE;

    /** Distance of the closest hit along the ray, in meters. */
    public static final int DISTANCE = DIRECTION_X + 6 * SIZE;

    /** Body number of the closest hit as a float (exact for any scene): see {@link Layout}, or {@link #ENDED}. */
    public static final int HIT = DIRECTION_X + 7 * SIZE;

    /** Factor for the light found from here on; 0 once the path has ended. */
    public static final int THROUGHPUT = DIRECTION_X + 8 * SIZE;

    public static final int RED = DIRECTION_X + 9 * SIZE;
    public static final int GREEN = DIRECTION_X + 10 * SIZE;
    public static final int BLUE = DIRECTION_X + 11 * SIZE;

    /** The hit point. */
    public static final int POINT_X = DIRECTION_X + 12 * SIZE;

    public static final int POINT_Y = DIRECTION_X + 13 * SIZE;
    public static final int POINT_Z = DIRECTION_X + 14 * SIZE;

    /**
     * The surface hit, from the normal to the reflectivity. First holds a copy of the body's
     * {@code BodyColumns.surfaces}, in the same order.
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

    /** Unit vector from the surface to the light's center, and its distance in meters. */
    public static final int TO_LIGHT_X = DIRECTION_X + 23 * SIZE;

    public static final int TO_LIGHT_Y = DIRECTION_X + 24 * SIZE;
    public static final int TO_LIGHT_Z = DIRECTION_X + 25 * SIZE;
    public static final int LIGHT_DISTANCE = DIRECTION_X + 26 * SIZE;
    public static final int NORMAL_DOT_LIGHT = DIRECTION_X + 27 * SIZE;

    /** Vector from the sphere's center to the hit point; valid until the direction to the light is known. */
    public static final int FROM_CENTER_X = TO_LIGHT_X;

    public static final int FROM_CENTER_Y = TO_LIGHT_Y;
    public static final int FROM_CENTER_Z = TO_LIGHT_Z;

    /** S, the visible part of the light. */
    public static final int VISIBLE = DIRECTION_X + 28 * SIZE;

    /** 1 while S is unknown, else 0. */
    public static final int SHADOW_OPEN = DIRECTION_X + 29 * SIZE;

    public static final int SPECULAR = DIRECTION_X + 30 * SIZE;

    /** Coordinates in the sky: angles in radians, then columns and rows in texels, then fractions of a texel. */
    public static final int SKY_TO_RIGHT = DIRECTION_X + 31 * SIZE;

    public static final int SKY_TO_BOTTOM = DIRECTION_X + 32 * SIZE;

    /** The body that the ray leaves. */
    public static final int LEAVING = DIRECTION_X + 33 * SIZE;

    /** Tangent and secant of the half angle of the light's disc, seen from the surface. */
    public static final int DISC_TANGENT = DIRECTION_X + 34 * SIZE;

    public static final int DISC_SECANT = DIRECTION_X + 35 * SIZE;

    /** A cosine raised to the fractional part of a reflectivity. */
    public static final int FRACTION_POWER = DIRECTION_X + 36 * SIZE;

    /** Factor for the cosine's power. */
    public static final int SPECULAR_WEIGHT = DIRECTION_X + 37 * SIZE;

    /** 1 for coherent rays, which traverse the hierarchy as one beam; else 0. */
    public static final int TOGETHER = DIRECTION_X + 38 * SIZE;

    /** The pixel's column and row in the tile. */
    public static final int PLACE_X = DIRECTION_X + 39 * SIZE;

    public static final int PLACE_Y = DIRECTION_X + 40 * SIZE;

    /**
     * Material properties beyond color and reflectivity, in the order of a body's looks; only in frames that have such
     * bodies.
     */
    public static final int ROUGHNESS = DIRECTION_X + 41 * SIZE;

    public static final int TRANSMISSION = DIRECTION_X + 42 * SIZE;
    public static final int IOR = DIRECTION_X + 43 * SIZE;
    public static final int TEXTURE = DIRECTION_X + 44 * SIZE;
    public static final int METALLIC = DIRECTION_X + 45 * SIZE;

    /** The size of the texture in texels. */
    public static final int TEXTURE_WIDTH = DIRECTION_X + 46 * SIZE;

    public static final int TEXTURE_HEIGHT = DIRECTION_X + 47 * SIZE;

    /** Texture coordinates on a mesh; valid until the texture's size is known. */
    public static final int TEXTURE_U = TEXTURE_WIDTH;

    public static final int TEXTURE_V = TEXTURE_HEIGHT;

    /** Normal of the reflecting microfacet, turned toward the ray's origin. */
    public static final int FACET_X = DIRECTION_X + 48 * SIZE;

    public static final int FACET_Y = DIRECTION_X + 49 * SIZE;
    public static final int FACET_Z = DIRECTION_X + 50 * SIZE;

    /** Column and row of the upper left of the texels around the hit point, from -1 on. */
    public static final int TEXEL_COLUMN = FACET_X;

    public static final int TEXEL_ROW = FACET_Y;

    /** Sums over several lights, while these shade: of the factors of matte surfaces' colors, and of the highlights. */
    public static final int LIT = SKY_TO_RIGHT;

    public static final int HIGHLIGHT_RED = FACET_X;
    public static final int HIGHLIGHT_GREEN = FACET_Y;
    public static final int HIGHLIGHT_BLUE = FACET_Z;

    /** Two random numbers in [0, 1) that choose the microfacet. */
    public static final int FIRST_NUMBER = SKY_TO_RIGHT;

    public static final int SECOND_NUMBER = SKY_TO_BOTTOM;

    /** A view ray's point on the lens, relative to the camera, in meters. */
    public static final int LENS_RIGHT = POINT_X;

    public static final int LENS_UP = POINT_Y;

    /** Cosines of a rough surface's normal with the incoming and an outgoing ray; valid once the facet is known. */
    public static final int COSINE_IN = SKY_TO_RIGHT;

    public static final int COSINE_OUT = SKY_TO_BOTTOM;

    /**
     * {@link Layout#INSIDE} of the ray, above 0 where it continues inside the body that it leaves; and 1 where it hits
     * the body from inside, else 0.
     */
    public static final int INSIDE = DIRECTION_X + 51 * SIZE;

    public static final int FROM_INSIDE = DIRECTION_X + 52 * SIZE;

    /** The throughput before the surface. */
    public static final int WHOLE = DIRECTION_X + 53 * SIZE;

    /** Color of the transmitted light, while the albedo holds the color of the untransmitted part. */
    public static final int PASSED_RED = DIRECTION_X + 54 * SIZE;

    public static final int PASSED_GREEN = DIRECTION_X + 55 * SIZE;
    public static final int PASSED_BLUE = DIRECTION_X + 56 * SIZE;

    /** Factor for the colors found, in a tile of branch rays; 1 in other tiles. */
    public static final int TINT_RED = DIRECTION_X + 57 * SIZE;

    public static final int TINT_GREEN = DIRECTION_X + 58 * SIZE;
    public static final int TINT_BLUE = DIRECTION_X + 59 * SIZE;

    /** Number of the pixel that the ray contributes to. */
    public static final int PIXEL = DIRECTION_X + 60 * SIZE;

    /** The refracted ray and its part of the throughput; valid once the surface is shaded. */
    public static final int REFRACTED_X = TO_LIGHT_X;

    public static final int REFRACTED_Y = TO_LIGHT_Y;
    public static final int REFRACTED_Z = TO_LIGHT_Z;
    public static final int REFRACTED_PART = SPECULAR;

    /** Tint of the next ray, and whether it continues inside. */
    public static final int NEXT_RED = FACET_X;

    public static final int NEXT_GREEN = FACET_Y;
    public static final int NEXT_BLUE = FACET_Z;
    public static final int NEXT_INSIDE = VISIBLE;

    /**
     * Of a sphere's center: the distance along the ray, the squared half chord, and the squared distance; valid until
     * the hit points are known.
     */
    public static final int SPHERE_ALONG = POINT_X;

    public static final int SPHERE_CHORD = POINT_Y;
    public static final int SPHERE_AWAY = POINT_Z;

    /** A rough surface's microfacet in the tangent frame; valid until the facet is known. */
    public static final int LOCAL_X = TO_LIGHT_X;

    public static final int LOCAL_Y = TO_LIGHT_Y;
    public static final int LOCAL_Z = TO_LIGHT_Z;

    /** The triangle that the ray leaves, where the body is a mesh. */
    public static final int LEAVING_TRIANGLE = DIRECTION_X + 61 * SIZE;

    /** For a mesh hit: instance, triangle and face normal. */
    public static final int INSTANCE = DIRECTION_X + 62 * SIZE;

    public static final int TRIANGLE = DIRECTION_X + 63 * SIZE;
    public static final int FACE_X = DIRECTION_X + 64 * SIZE;
    public static final int FACE_Y = DIRECTION_X + 65 * SIZE;
    public static final int FACE_Z = DIRECTION_X + 66 * SIZE;

    /** Light samples blocked by meshes, in packets of {@link #meshShadows}; a sample may be blocked in part. */
    public static final int MESH_BLOCKED = DIRECTION_X + 67 * SIZE;

    /** What metals multiply reflected light and highlights by; 1 for other surfaces. */
    public static final int SHEEN_RED = DIRECTION_X + 68 * SIZE;

    public static final int SHEEN_GREEN = DIRECTION_X + 69 * SIZE;
    public static final int SHEEN_BLUE = DIRECTION_X + 70 * SIZE;

    private static final int COLUMNS = 71;

    /** Columns of {@link #corners}. */
    public static final int UPPER_LEFT = Lanes.BORDER;

    public static final int UPPER_RIGHT = UPPER_LEFT + SIZE;
    public static final int LOWER_LEFT = UPPER_LEFT + 2 * SIZE;
    public static final int LOWER_RIGHT = UPPER_LEFT + 3 * SIZE;
    public static final int CORNERS = 4;

    /** {@link #HIT} of a lane whose path has already ended. */
    public static final float ENDED = -2f;

    /** The columns above, from {@link Lanes#BORDER} on. */
    public final float[] values = new float[DIRECTION_X + COLUMNS * SIZE];

    /** Offset of the upper left texel in the padded sky, in texels. */
    public final int[] texels = new int[SIZE];

    /** The number of every pixel. */
    public final int[] pixels = new int[SIZE];

    /** Pixels that are handled one by one: for the sky, for hits in a crowd, or for shadows. */
    public final PixelList lonely = new PixelList(SIZE);

    /** Starts, in {@code BodyColumns.surfaces}, of the spheres to copy next. */
    public final int[] surfacePlaces = new int[SIZE];

    /** Sink for prefetch reads; keeps C2 from eliminating them. */
    public float readAhead;

    /** The four texels around each pixel's direction, encoded like {@link PaddedSky#shared}, in columns. */
    public final int[] corners = new int[Lanes.BORDER + CORNERS * SIZE];

    /** The same as floats: all red values, then green, then blue. */
    public final float[] cornerNumbers = new float[Lanes.BORDER + PaddedSky.NUMBERS_A_TEXEL * CORNERS * SIZE];

    /** The finished pixels, from {@link Lanes#BORDER} on. */
    public final int[] argb = new int[Lanes.BORDER + SIZE];

    /**
     * Packets by the place of their first pixel: those with live paths, then those by the kind of hit or pending step.
     */
    public final PacketList live = new PacketList(PACKETS);

    public final PacketList skies = new PacketList(PACKETS);
    public final PatchList skyPatches = new PatchList(PACKETS);
    public final PacketList scatteredSkies = new PacketList(PACKETS);
    public final PacketList lights = new PacketList(PACKETS);
    public final PacketList grounds = new PacketList(PACKETS);
    public final PacketList spheres = new PacketList(PACKETS);
    public final PacketList surfaces = new PacketList(PACKETS);
    public final PacketList shadows = new PacketList(PACKETS);

    /** Packets of {@link #spheres} that hit meshes. */
    public final PacketList meshes = new PacketList(PACKETS);

    /** Packets for which meshes block part of the light. */
    public final PacketList meshShadows = new PacketList(PACKETS);

    /** Packets with textured surfaces. */
    public final PacketList textures = new PacketList(PACKETS);

    /** Packets with rough surfaces. */
    public final PacketList rough = new PacketList(PACKETS);

    /** Packets with transmitting surfaces. */
    public final PacketList transparent = new PacketList(PACKETS);

    /** Packets with metals. */
    public final PacketList metals = new PacketList(PACKETS);

    /** Packets with coherent rays ({@link #TOGETHER}). */
    public final PacketList together = new PacketList(PACKETS);

    /** Packets with highlights: by one integer exponent, by several integer exponents, and by any exponents. */
    public final PacketList onePower = new PacketList(PACKETS);

    public final PacketList wholePowers = new PacketList(PACKETS);
    public final PacketList fractionPowers = new PacketList(PACKETS);

    /** The exponent of each packet in {@link #onePower}, by packet number. */
    public final float[] powers = new float[SIZE / Lanes.COUNT];

    /** Bodies that the live rays may hit. */
    public final BodyList candidates = new BodyList();

    /** Those candidates that transmit, once {@code TransmittingSphere} has separated them. */
    public final BodyList transmitting = new BodyList();

    /** Whether the live rays may hit a mesh. Mesh hits count as sphere hits. */
    public boolean nearMeshes;

    /** Position of the first pixel in the frame. */
    public int left;

    public int top;

    /** Number of the light that shades, from 0 on. */
    public int light;

    /** Number of the pixel sample being rendered. */
    public int sample;

    /** Number of rays in a tile of branch rays. */
    public int rays;

    /** Whether no rays continue after this bounce. */
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

    /** Moves this tile to another one's position. */
    public void moveTo(Tile other) {
        left = other.left;
        top = other.top;
    }

    /** Column in [0, {@link #SIDE}) of a pixel number. */
    public static int column(int pixel) {
        int block = pixel / BLOCK;
        return block % (SIDE / BLOCK_SIDE) * BLOCK_SIDE + pixel % BLOCK_SIDE;
    }

    /** Row in [0, {@link #SIDE}) of a pixel number. */
    public static int row(int pixel) {
        int block = pixel / BLOCK;
        return block / (SIDE / BLOCK_SIDE) * BLOCK_SIDE + pixel % BLOCK / BLOCK_SIDE;
    }
}
