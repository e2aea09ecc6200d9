package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.step.CameraLanes;
import dev.twister.engine.vector.step.SkyDirection;
import dev.twister.kernel.Layout;
import dev.twister.world.View;
import jdk.incubator.vector.FloatVector;

/**
 * Maps the view rays of a block of tiles to positions in the panorama, by cubic polynomials of the pixel's column and
 * row. They replace the two arc tangents per pixel in {@code SkyDirection}. The polynomials are exact at 4 x 4 nodes,
 * from the block's first pixel to its last, and are used only where their error in between is no larger than a float's
 * rounding.
 *
 * <p>Let e be the sine of the largest angle between adjacent nodes, divided by the cosine of the elevation. Along a
 * line of pixels, the nth derivative of the azimuth per step of the nodes is at most {@code (n - 1)! e^n}, because the
 * azimuth is the imaginary part of a logarithm. Twice that bounds the derivative of the elevation. A cubic polynomial
 * through four nodes one step apart therefore has an error of at most {@code 2 * 3! / 4! * e^4}.
 */
public final class SkyChart {
    /** Nodes along each side; equal to the number of a cubic polynomial's coefficients. */
    private static final int SIDE = 4;

    private static final int NODES = SIDE * SIDE;

    /** Largest accepted error in radians: two units in the last place of a full turn as a float. */
    private static final float MOST_ERROR = 1e-6f;

    /** Number of tiles across the largest block. */
    private static final int MOST_TILES = 4;

    /** Squared cosine of the elevation up to which the size of the blocks is chosen to meet {@link #MOST_ERROR}. */
    private static final float USUAL_LEVEL_SQUARED = 0.5f;

    /** Distance from a tile's first pixel to its center. */
    private static final float MIDDLE = 0.5f * (Tile.SIDE - 1);

    /** Margins: factor for the slope between nodes, and texels for rounding. */
    private static final float GENEROUS = 1.01f;

    private static final float MORE = 0.01f;

    private static final int BLOCKS_ACROSS = Tile.SIDE / Tile.BLOCK_SIDE;

    /** The nodes as rays, in the first sixteen places. */
    private final Tile nodes = new Tile();

    /** Coefficients of column and row in the padded sky; that of {@code down^j across^i} is at {@code 4 j + i}. */
    private final float[] columnFactors = new float[NODES];

    private final float[] rowFactors = new float[NODES];

    /** Per block of pixels across a tile, the coefficients of {@code down^j} for each of its pixel columns. */
    private final float[] columnsAcross = new float[Lanes.BORDER + BLOCKS_ACROSS * SIDE * Lanes.COUNT];

    private final float[] rowsAcross = new float[columnsAcross.length];

    private final float[][] factorsOfBoth = {columnFactors, rowFactors};
    private final float[][] acrossOfBoth = {columnsAcross, rowsAcross};

    /** Width of the block of tiles in pixels. */
    private int width;

    /** Whether even a block of one tile at the horizon exceeds the error. */
    private boolean hopeless;

    /** Largest angle between adjacent pixels, in radians. */
    private float step;

    private boolean exact;

    /** Largest number of sky columns and rows per step of one pixel across plus one down. */
    private float columnsAStep;

    private float rowsAStep;

    SkyChart() {
        for (int node = 0; node < NODES; node += Lanes.COUNT) {
            nodes.live.add(node);
            nodes.skies.add(node);
        }
    }

    /** Prepares a frame. */
    void start(Drawing drawing) {
        step = drawing.viewportStep / drawing.input.view().frame()[Layout.CAMERA_EYE_DISTANCE];
        int tiles = MOST_TILES;
        while (tiles > 1 && error(tiles * Tile.SIDE, USUAL_LEVEL_SQUARED) > MOST_ERROR) {
            tiles /= 2;
        }
        width = tiles * Tile.SIDE;
        hopeless = error(width, 1f) > MOST_ERROR;
        nodes.left = -1;
        for (int node = 0; node < NODES; node++) {
            int row = node / SIDE;
            nodes.values[Tile.PLACE_X + node] = (node - row * SIDE) * stepAcross();
            nodes.values[Tile.PLACE_Y + node] = row * stepDown();
        }
    }

    /** Whether the frame's pixels are so large that a block has only one tile. */
    boolean isCoarse() {
        return width <= Tile.SIDE;
    }

    /** Distance between nodes in pixels. */
    private float stepAcross() {
        return (width - 1) / (SIDE - 1f);
    }

    private static float stepDown() {
        return (Tile.SIDE - 1) / (SIDE - 1f);
    }

    /** Bound of the error in radians, for the given minimum of the squared cosine of the elevation. */
    private float error(int pixelsAcross, float levelSquared) {
        float across = (pixelsAcross - 1) / (SIDE - 1f) * step;
        float down = stepDown() * step;
        float acrossSquared = across * across / levelSquared;
        float downSquared = down * down / levelSquared;
        return 0.5f * (acrossSquared * acrossSquared + downSquared * downSquared);
    }

    /** Whether the polynomials are accurate enough for the tile; computes those of its block if necessary. */
    boolean covers(Tile tile, Drawing drawing) {
        if (hopeless) {
            return false;
        }
        int left = tile.left - tile.left % width;
        if (nodes.left != left || nodes.top != tile.top) {
            nodes.left = left;
            nodes.top = tile.top;
            CameraLanes.aim(nodes, drawing);
            SkyDirection.find(drawing.sky, nodes);
            exact = judge(drawing.sky.width);
            if (exact) {
                findFactors(Tile.SKY_TO_RIGHT, columnFactors);
                findFactors(Tile.SKY_TO_BOTTOM, rowFactors);
                columnsAStep = steepest(Tile.SKY_TO_RIGHT);
                rowsAStep = steepest(Tile.SKY_TO_BOTTOM);
            }
        }
        return exact;
    }

    /** Whether the block is far enough from zenith and nadir and does not cross the panorama's seam. */
    private boolean judge(int skyWidth) {
        float[] t = nodes.values;
        float steepest = 0f;
        float farthest = 0f;
        for (int node = 0; node < NODES; node++) {
            steepest = Math.max(steepest, Math.abs(t[Tile.DIRECTION_Y + node]));
            farthest = Math.max(farthest, Math.abs(t[Tile.SKY_TO_RIGHT + node] - t[Tile.SKY_TO_RIGHT]));
        }
        float levelSquared = 1f - steepest * steepest;
        return farthest < 0.5f * skyWidth && levelSquared > 0f && error(width, levelSquared) <= MOST_ERROR;
    }

    private float steepest(int column) {
        float[] t = nodes.values;
        float across = 0f;
        float down = 0f;
        for (int node = 0; node < NODES; node++) {
            if (node % SIDE > 0) {
                across = Math.max(across, Math.abs(t[column + node] - t[column + node - 1]));
            }
            if (node >= SIDE) {
                down = Math.max(down, Math.abs(t[column + node] - t[column + node - SIDE]));
            }
        }
        return across / stepAcross() + down / stepDown();
    }

    /**
     * Loads the texels that a covered tile's view rays see, or their mirror images, into the window; returns whether
     * they fit.
     */
    boolean open(SkyWindow window, Tile tile, Drawing drawing, boolean mirrored) {
        View view = drawing.input.view();
        float across =
                (tile.left - nodes.left + MIDDLE + view.sample(tile.sample, 0) - view.sample(0, 0)) / stepAcross();
        float down = (MIDDLE + view.sample(tile.sample, 1) - view.sample(0, 1)) / stepDown();
        float column = value(columnFactors, across, down);
        float row = value(rowFactors, across, down);
        if (mirrored) {
            row = drawing.sky.height + 1f - row;
        }
        float columns = MIDDLE * columnsAStep * GENEROUS + MORE;
        float rows = MIDDLE * rowsAStep * GENEROUS + MORE;
        return window.take(drawing.sky, column - columns, row - rows, column + columns, row + rows);
    }

    private static float value(float[] factors, float across, float down) {
        float sum = 0f;
        for (int power = NODES - SIDE; power >= 0; power -= SIDE) {
            float term = factors[power + 3] * across + factors[power + 2];
            term = term * across + factors[power + 1];
            sum = sum * down + (term * across + factors[power]);
        }
        return sum;
    }

    /**
     * Computes the coefficients from the nodes' values, relative to the first value, which keeps rounding errors small.
     */
    private void findFactors(int column, float[] factors) {
        float[] t = nodes.values;
        float first = t[column];
        for (int node = 0; node < NODES; node++) {
            factors[node] = t[column + node] - first;
        }
        for (int k = 0; k < SIDE; k++) {
            solve(factors, SIDE * k, 1);
        }
        for (int k = 0; k < SIDE; k++) {
            solve(factors, k, SIDE);
        }
        factors[0] += first;
    }

    /**
     * Replaces values at 0, 1, 2 and 3, {@code stride} apart, by the coefficients of the cubic polynomial through them.
     */
    private static void solve(float[] values, int first, int stride) {
        float start = values[first];
        float one = values[first + stride] - start;
        float two = values[first + 2 * stride] - start;
        float three = values[first + 3 * stride] - start;
        values[first + stride] = 3f * one - 1.5f * two + three / 3f;
        values[first + 2 * stride] = 2f * two - 2.5f * one - 0.5f * three;
        values[first + 3 * stride] = 0.5f * (one - two) + three / 6f;
    }

    /** Computes the coefficients that are shared by a pixel column of a covered tile. */
    void spread(Tile tile, Drawing drawing) {
        for (int k = 0; k < factorsOfBoth.length; k++) {
            spread(drawing, tile, factorsOfBoth[k], acrossOfBoth[k]);
        }
    }

    private void spread(Drawing drawing, Tile tile, float[] factors, float[] to) {
        View view = drawing.input.view();
        float inverse = 1f / stepAcross();
        float from = (tile.left - nodes.left + view.sample(tile.sample, 0) - view.sample(0, 0)) * inverse;
        float[] t = tile.values;
        for (int block = 0; block < BLOCKS_ACROSS; block++) {
            FloatVector across = Lanes.load(t, Tile.PLACE_X + block * Tile.BLOCK)
                    .mul(inverse)
                    .add(from);
            for (int power = 0; power < SIDE; power++) {
                int factor = power * SIDE;
                FloatVector sum = Lanes.fma(across, factors[factor + 3], factors[factor + 2]);
                sum = Lanes.fma(sum, across, Lanes.all(factors[factor + 1]));
                Lanes.fma(sum, across, Lanes.all(factors[factor]))
                        .intoArray(to, Lanes.BORDER + (block * SIDE + power) * Lanes.COUNT);
            }
        }
    }

    /**
     * Writes the columns and rows of the padded sky that a covered tile's view rays see.
     *
     * @param mirrored whether the rays are mirrored in a level plane
     */
    void place(Tile tile, Drawing drawing, boolean mirrored) {
        View view = drawing.input.view();
        float inverse = 1f / stepDown();
        float from = (view.sample(tile.sample, 1) - view.sample(0, 1)) * inverse;
        // The rows of a direction and its mirror image are symmetric about the horizon.
        float turned = mirrored ? -1f : 1f;
        float end = mirrored ? drawing.sky.height + 1f : 0f;
        float[] t = tile.values;
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k];
            int factors = Lanes.BORDER + at / Tile.BLOCK % BLOCKS_ACROSS * SIDE * Lanes.COUNT;
            FloatVector down = Lanes.load(t, at + Tile.PLACE_Y).mul(inverse).add(from);
            FloatVector column = Lanes.load(columnsAcross, factors + 3 * Lanes.COUNT);
            column = Lanes.fma(column, down, Lanes.load(columnsAcross, factors + 2 * Lanes.COUNT));
            column = Lanes.fma(column, down, Lanes.load(columnsAcross, factors + Lanes.COUNT));
            Lanes.fma(column, down, Lanes.load(columnsAcross, factors)).intoArray(t, at + Tile.SKY_TO_RIGHT);
            FloatVector row = Lanes.load(rowsAcross, factors + 3 * Lanes.COUNT);
            row = Lanes.fma(row, down, Lanes.load(rowsAcross, factors + 2 * Lanes.COUNT));
            row = Lanes.fma(row, down, Lanes.load(rowsAcross, factors + Lanes.COUNT));
            row = Lanes.fma(row, down, Lanes.load(rowsAcross, factors));
            Lanes.fma(row, turned, end).intoArray(t, at + Tile.SKY_TO_BOTTOM);
        }
    }
}
