package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.ArcTangent;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.KernelMath;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Texture;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * Textures: {@link dev.twister.kernel.Texture}. Texture coordinates are computed in lanes, texels are fetched pixel by
 * pixel, and interpolation is in lanes again.
 */
public final class TextureLanes {
    private static final int CHANNELS = 3;
    private static final float TURNS_PER_RADIAN = 0.15915494f;
    private static final float HALF_TURNS_PER_RADIAN = 0.31830987f;

    /** Smaller than any relevant coordinate and positive: avoids 0 / 0. */
    private static final float TINY = 1e-37f;

    private TextureLanes() {}

    /** Multiplies the albedo of textured surfaces by the texture's color. */
    public static void multiply(Drawing drawing, Tile tile) {
        list(tile);
        if (tile.textures.count > 0) {
            findTurns(tile);
            findHeights(tile);
            findRepeats(tile, drawing.bodies.meshes.firstBody);
            fetchSizes(tile, drawing);
            findUpperLeft(tile, drawing.bodies.meshes.firstBody);
            findTexels(tile);
            fetch(tile, drawing);
            multiply(tile);
        }
    }

    /** Lists the packets and the pixels with a texture. */
    static void list(Tile tile) {
        tile.textures.clear();
        float[] t = tile.values;
        int count = 0;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            long textured = Lanes.load(t, at + Tile.TEXTURE)
                    .compare(VectorOperators.GT, 0f)
                    .toLong();
            if (textured != 0L) {
                tile.textures.add(at);
                Lanes.pack(tile.pixels, at, textured, tile.lonely.pixels, count);
                count += Long.bitCount(textured);
            }
        }
        tile.lonely.count = count;
    }

    /** Writes the horizontal texture coordinates of the normals, in [0, 1] from the left. */
    static void findTurns(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.textures.count; k++) {
            int at = tile.textures.places[k];
            FloatVector x = Lanes.load(t, at + Tile.NORMAL_X);
            FloatVector z = Lanes.load(t, at + Tile.NORMAL_Z);
            FloatVector across = x.abs();
            FloatVector ahead = z.abs();
            VectorMask<Float> sideways = across.compare(VectorOperators.GT, ahead);
            FloatVector octant = ArcTangent.of(
                    across.blend(ahead, sideways).div(Lanes.larger(ahead.blend(across, sideways), Lanes.all(TINY))));
            FloatVector quadrant = octant.blend(Lanes.all(KernelMath.HALF_PI).sub(octant), sideways);
            FloatVector half =
                    quadrant.blend(Lanes.all(KernelMath.PI).sub(quadrant), z.compare(VectorOperators.GT, 0f));
            FloatVector turns = half.blend(half.neg(), x.compare(VectorOperators.LT, 0f))
                    .mul(TURNS_PER_RADIAN)
                    .add(0.5f);
            turns.blend(turns.add(1f), turns.compare(VectorOperators.LT, 0f)).intoArray(t, at + Tile.SKY_TO_RIGHT);
        }
    }

    /** Writes their vertical texture coordinates, in [0, 1] from the top. */
    static void findHeights(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.textures.count; k++) {
            int at = tile.textures.places[k];
            FloatVector x = Lanes.load(t, at + Tile.NORMAL_X);
            FloatVector y = Lanes.load(t, at + Tile.NORMAL_Y);
            FloatVector z = Lanes.load(t, at + Tile.NORMAL_Z);
            FloatVector level = Lanes.fma(x, x, z.mul(z)).sqrt();
            FloatVector up = y.abs();
            VectorMask<Float> steep = up.compare(VectorOperators.GT, level);
            FloatVector octant =
                    ArcTangent.of(up.blend(level, steep).div(Lanes.larger(level.blend(up, steep), Lanes.all(TINY))));
            FloatVector quadrant = octant.blend(Lanes.all(KernelMath.HALF_PI).sub(octant), steep);
            FloatVector elevation = quadrant.blend(quadrant.neg(), y.compare(VectorOperators.LT, 0f));
            Lanes.all(0.5f).sub(elevation.mul(HALF_TURNS_PER_RADIAN)).intoArray(t, at + Tile.SKY_TO_BOTTOM);
        }
    }

    /** As above for the plane, on which the texture repeats every meter, and for meshes, which have coordinates. */
    static void findRepeats(Tile tile, int firstMesh) {
        float[] t = tile.values;
        for (int k = 0; k < tile.textures.count; k++) {
            int at = tile.textures.places[k];
            FloatVector hit = Lanes.load(t, at + Tile.HIT);
            VectorMask<Float> mesh = hit.compare(VectorOperators.GE, firstMesh);
            VectorMask<Float> repeats = mesh.or(hit.compare(VectorOperators.EQ, Layout.PLANE));
            FloatVector u = Lanes.load(t, at + Tile.POINT_X).blend(Lanes.load(t, at + Tile.TEXTURE_U), mesh);
            FloatVector v = Lanes.load(t, at + Tile.POINT_Z).neg().blend(Lanes.load(t, at + Tile.TEXTURE_V), mesh);
            Lanes.load(t, at + Tile.SKY_TO_RIGHT)
                    .blend(u.sub(Lanes.floor(u)), repeats)
                    .intoArray(t, at + Tile.SKY_TO_RIGHT);
            Lanes.load(t, at + Tile.SKY_TO_BOTTOM)
                    .blend(v.sub(Lanes.floor(v)), repeats)
                    .intoArray(t, at + Tile.SKY_TO_BOTTOM);
        }
    }

    /** Writes the size of each listed pixel's texture. */
    static void fetchSizes(Tile tile, Drawing drawing) {
        float[] t = tile.values;
        float[] looks = drawing.input.bodies().looks();
        int textures = drawing.input.bodies().textures();
        for (int k = 0; k < tile.lonely.count; k++) {
            int pixel = tile.lonely.pixels[k];
            int at = textures + Layout.MAPS_STRIDE * ((int) t[pixel + Tile.TEXTURE] - 1);
            t[pixel + Tile.TEXTURE_WIDTH] = looks[at + Layout.MAPS_COLOR + Layout.MAP_WIDTH];
            t[pixel + Tile.TEXTURE_HEIGHT] = looks[at + Layout.MAPS_COLOR + Layout.MAP_HEIGHT];
        }
    }

    /** Turns the coordinates into column and row of the upper left of four texels, and the fractions from there. */
    static void findUpperLeft(Tile tile, int firstMesh) {
        float[] t = tile.values;
        for (int k = 0; k < tile.textures.count; k++) {
            int at = tile.textures.places[k];
            FloatVector columns = Lanes.load(t, at + Tile.TEXTURE_WIDTH);
            FloatVector rows = Lanes.load(t, at + Tile.TEXTURE_HEIGHT);
            FloatVector column =
                    Lanes.load(t, at + Tile.SKY_TO_RIGHT).mul(columns).sub(0.5f);
            FloatVector row = Lanes.load(t, at + Tile.SKY_TO_BOTTOM).mul(rows).sub(0.5f);
            FloatVector toPole = Lanes.smaller(Lanes.larger(row, Lanes.all(0f)), rows.sub(1f));
            FloatVector hit = Lanes.load(t, at + Tile.HIT);
            VectorMask<Float> repeats =
                    hit.compare(VectorOperators.EQ, Layout.PLANE).or(hit.compare(VectorOperators.GE, firstMesh));
            row = toPole.blend(row, repeats);
            FloatVector left = Lanes.floor(column);
            FloatVector top = Lanes.floor(row);
            column.sub(left).intoArray(t, at + Tile.SKY_TO_RIGHT);
            row.sub(top).intoArray(t, at + Tile.SKY_TO_BOTTOM);
            left.intoArray(t, at + Tile.TEXEL_COLUMN);
            top.intoArray(t, at + Tile.TEXEL_ROW);
        }
    }

    /** Writes the four texels. */
    static void findTexels(Tile tile) {
        float[] t = tile.values;
        int[] corners = tile.corners;
        for (int k = 0; k < tile.textures.count; k++) {
            int at = tile.textures.places[k];
            FloatVector columns = Lanes.load(t, at + Tile.TEXTURE_WIDTH);
            FloatVector rows = Lanes.load(t, at + Tile.TEXTURE_HEIGHT);
            FloatVector left = Lanes.load(t, at + Tile.TEXEL_COLUMN);
            FloatVector top = Lanes.load(t, at + Tile.TEXEL_ROW);
            FloatVector right = left.add(1f);
            FloatVector bottom = top.add(1f);
            FloatVector lastColumn = columns.sub(1f);
            FloatVector lastRow = rows.sub(1f);
            right = right.blend(0f, right.compare(VectorOperators.GE, columns));
            bottom = bottom.blend(0f, bottom.compare(VectorOperators.GE, rows));
            left = Lanes.smaller(left.blend(lastColumn, left.compare(VectorOperators.LT, 0f)), lastColumn);
            top = Lanes.smaller(top.blend(lastRow, top.compare(VectorOperators.LT, 0f)), lastRow);
            IntVector width = Lanes.truncated(columns);
            IntVector upper = Lanes.truncated(top).mul(width);
            IntVector lower = Lanes.truncated(bottom).mul(width);
            IntVector first = Lanes.truncated(left);
            IntVector second = Lanes.truncated(right);
            upper.add(first).intoArray(corners, at + Tile.UPPER_LEFT);
            upper.add(second).intoArray(corners, at + Tile.UPPER_RIGHT);
            lower.add(first).intoArray(corners, at + Tile.LOWER_LEFT);
            lower.add(second).intoArray(corners, at + Tile.LOWER_RIGHT);
        }
    }

    /** Fetches the four texels of each listed pixel, pixel by pixel. */
    static void fetch(Tile tile, Drawing drawing) {
        float[] t = tile.values;
        float[] looks = drawing.input.bodies().looks();
        int textures = drawing.input.bodies().textures() + Layout.MAPS_COLOR;
        float[] from = drawing.input.images();
        float[] to = tile.cornerNumbers;
        int[] corners = tile.corners;
        for (int k = 0; k < tile.lonely.count; k++) {
            int pixel = tile.lonely.pixels[k];
            int map = textures + Layout.MAPS_STRIDE * ((int) t[pixel + Tile.TEXTURE] - 1);
            int start = Layout.ALIGNMENT * (int) looks[map + Layout.MAP_START];
            int packed = Texture.isPacked((int) looks[map + Layout.MAP_SAMPLER]);
            for (int channel = 0; channel < CHANNELS; channel++) {
                int place = Tile.CORNERS * channel * Tile.SIZE;
                for (int corner = Tile.UPPER_LEFT; corner <= Tile.LOWER_RIGHT; corner += Tile.SIZE) {
                    to[place + corner + pixel] = Texture.texel(start, packed, corners[corner + pixel], channel, from);
                }
            }
        }
    }

    /** Multiplies the albedo by the interpolated color. */
    public static void multiply(Tile tile) {
        for (int channel = 0; channel < CHANNELS; channel++) {
            multiply(tile.values, tile.cornerNumbers, channel, tile);
        }
    }

    private static void multiply(float[] t, float[] corners, int channel, Tile tile) {
        int albedo = Tile.ALBEDO_RED + channel * Tile.SIZE;
        int column = Tile.CORNERS * channel * Tile.SIZE;
        for (int k = 0; k < tile.textures.count; k++) {
            int at = tile.textures.places[k];
            FloatVector toRight = Lanes.load(t, at + Tile.SKY_TO_RIGHT);
            FloatVector upper = Lanes.load(corners, Tile.UPPER_LEFT + column + at);
            FloatVector lower = Lanes.load(corners, Tile.LOWER_LEFT + column + at);
            upper = Lanes.fma(
                    Lanes.load(corners, Tile.UPPER_RIGHT + column + at).sub(upper), toRight, upper);
            lower = Lanes.fma(
                    Lanes.load(corners, Tile.LOWER_RIGHT + column + at).sub(lower), toRight, lower);
            FloatVector color = Lanes.fma(lower.sub(upper), Lanes.load(t, at + Tile.SKY_TO_BOTTOM), upper);
            FloatVector before = Lanes.load(t, at + albedo);
            before.blend(before.mul(color), Lanes.load(t, at + Tile.TEXTURE).compare(VectorOperators.GT, 0f))
                    .intoArray(t, at + albedo);
        }
    }
}
