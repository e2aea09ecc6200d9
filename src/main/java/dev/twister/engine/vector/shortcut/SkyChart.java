package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.step.CameraLanes;
import dev.twister.engine.vector.step.SkyDirection;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;

/**
 * Where the view rays of a block of tiles look in the panorama: cubic polynomials of the pixel's place, across and
 * down, for what {@code SkyDirection} finds with two arc tangents a pixel. They meet it in 4 x 4 nodes, from the
 * block's first pixel to its last, and are used only where they are as exact between as a column is as a float.
 *
 * <p>With e the sine of the angle from one node to the next, at most, over the cosine of the elevation, the nth
 * derivative of an angle about the vertical along a line of pixels is at most {@code (n - 1)! e^n} a step of the nodes,
 * as it is the imaginary part of a logarithm; twice that holds an elevation. A cubic polynomial through four nodes a
 * step apart is so at most {@code 2 * 3! / 4! * e^4} away.
 */
public final class SkyChart {
    /** Of the nodes along each side; as many as a polynomial's coefficients. */
    private static final int SIDE = 4;

    private static final int NODES = SIDE * SIDE;

    /** In radians: two units in the last place of a whole turn as a float. */
    private static final float MOST_ERROR = 1e-6f;

    /** Tiles side by side in the largest block. */
    private static final int MOST_TILES = 4;

    /** Blocks are made so large that elevations up to that cosine, squared, are as exact as that. */
    private static final float USUAL_LEVEL_SQUARED = 0.5f;

    /** From a tile's first pixel to its middle. */
    private static final float MIDDLE = 0.5f * (Tile.SIDE - 1);

    /** A slope may be so much steeper between nodes, and rounding that many texels wrong. */
    private static final float GENEROUS = 1.01f;

    private static final float MORE = 0.01f;

    private static final int BLOCKS_ACROSS = Tile.SIDE / Tile.BLOCK_SIDE;

    /** The nodes as rays; the places of the first sixteen are theirs. */
    private final Tile nodes = new Tile();

    /** Of column and row in the padded sky: {@code down^j across^i} has the factor at {@code 4 j + i}. */
    private final float[] columnFactors = new float[NODES];

    private final float[] rowFactors = new float[NODES];

    /** For each block of pixels across a tile, the factors of {@code down^j} in its columns of pixels. */
    private final float[] columnsAcross = new float[Lanes.BORDER + BLOCKS_ACROSS * SIDE * Lanes.COUNT];

    private final float[] rowsAcross = new float[columnsAcross.length];

    private final float[][] factorsOfBoth = {columnFactors, rowFactors};
    private final float[][] acrossOfBoth = {columnsAcross, rowsAcross};

    /** Pixels across the block of tiles. */
    private int width;

    /** Whether not even blocks of one tile at the horizon are small enough. */
    private boolean hopeless;

    /** Radians from one pixel to the next, at most. */
    private float step;

    private boolean exact;

    /** How many columns and rows of the sky a step of a pixel across and one down take together, at most. */
    private float columnsAStep;

    private float rowsAStep;

    SkyChart() {
        for (int node = 0; node < NODES; node += Lanes.COUNT) {
            nodes.live.add(node);
            nodes.skies.add(node);
        }
    }

    /** Begins a frame. */
    void start(Drawing drawing) {
        step = drawing.viewportStep / drawing.input.view().camera()[Layout.CAMERA_EYE_DISTANCE];
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

    /** Whether the frame's pixels are so large that not even two tiles are one block. */
    boolean isCoarse() {
        return width <= Tile.SIDE;
    }

    /** Pixels from one node to the next. */
    private float stepAcross() {
        return (width - 1) / (SIDE - 1f);
    }

    private static float stepDown() {
        return (Tile.SIDE - 1) / (SIDE - 1f);
    }

    /** In radians, at most, where the cosine of the elevation is at least that, squared. */
    private float error(int pixelsAcross, float levelSquared) {
        float across = (pixelsAcross - 1) / (SIDE - 1f) * step;
        float down = stepDown() * step;
        float acrossSquared = across * across / levelSquared;
        float downSquared = down * down / levelSquared;
        return 0.5f * (acrossSquared * acrossSquared + downSquared * downSquared);
    }

    /** Whether the polynomials are exact enough for the tile; finds those of its block first, if they are another's. */
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

    /** Far enough from the zenith and the nadir, and not across the panorama's seam, which would cut a corner off. */
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
     * Has the window take what a covered tile's view rays look at, or their mirror images; tells whether there is room.
     */
    boolean open(SkyWindow window, Tile tile, Drawing drawing, boolean mirrored) {
        float[] offsets = drawing.input.view().pixelSamples();
        float across = (tile.left - nodes.left + MIDDLE + offsets[Layout.SAMPLE_STRIDE * tile.sample] - offsets[0])
                / stepAcross();
        float down = (MIDDLE + offsets[Layout.SAMPLE_STRIDE * tile.sample + 1] - offsets[1]) / stepDown();
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

    /** From values at the nodes, counted from the first one's, as that keeps the rounding small. */
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

    /** Replaces values at 0, 1, 2 and 3, {@code stride} apart, by the factors of the cubic polynomial through them. */
    private static void solve(float[] values, int first, int stride) {
        float start = values[first];
        float one = values[first + stride] - start;
        float two = values[first + 2 * stride] - start;
        float three = values[first + 3 * stride] - start;
        values[first + stride] = 3f * one - 1.5f * two + three / 3f;
        values[first + 2 * stride] = 2f * two - 2.5f * one - 0.5f * three;
        values[first + 3 * stride] = 0.5f * (one - two) + three / 6f;
    }

    /** Works out what the pixels of a column of a covered tile share. */
    void spread(Tile tile, Drawing drawing) {
        for (int k = 0; k < factorsOfBoth.length; k++) {
            spread(drawing, tile, factorsOfBoth[k], acrossOfBoth[k]);
        }
    }

    private void spread(Drawing drawing, Tile tile, float[] factors, float[] to) {
        float[] offsets = drawing.input.view().pixelSamples();
        float inverse = 1f / stepAcross();
        float from = (tile.left - nodes.left + offsets[Layout.SAMPLE_STRIDE * tile.sample] - offsets[0]) * inverse;
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
     * Writes the columns and rows of the padded sky that a covered tile's view rays look at.
     *
     * @param mirrored whether it is the rays' mirror images in a level plane that look
     */
    void place(Tile tile, Drawing drawing, boolean mirrored) {
        float[] offsets = drawing.input.view().pixelSamples();
        float inverse = 1f / stepDown();
        float from = (offsets[Layout.SAMPLE_STRIDE * tile.sample + 1] - offsets[1]) * inverse;
        // The rows of a direction and its mirror image are as far from either end.
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
