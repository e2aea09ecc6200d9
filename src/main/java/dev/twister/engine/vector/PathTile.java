package dev.twister.engine.vector;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.made.ArriveLanes;
import dev.twister.engine.vector.made.FindLanes;
import dev.twister.engine.vector.made.LightLanes;
import dev.twister.engine.vector.made.PathColumns;
import dev.twister.engine.vector.made.StartLanes;
import dev.twister.kernel.Intersection;
import dev.twister.kernel.Layout;
import dev.twister.kernel.PathTracer;
import dev.twister.kernel.PixelKernel;

/**
 * The traced paths of a tile, ray by ray. Packets find the closest hits of rays that fill them; made lanes do
 * everything else. A path that ends is replaced by its pixel's next sample at once, so that lanes stay full.
 */
final class PathTile {
    private static final int PACKETS = Tile.SIZE / Lanes.COUNT;
    private static final int FIRST = PathColumns.FIRST_PARAMETER;

    private final TileMemory bench;
    private final BounceRenderer bounces;
    private final PathSlots slots = new PathSlots(Tile.SIZE);
    private final PathColumns columns = slots.columns;
    private final int[] packets = new int[PACKETS];

    /** For the pixels that are stored. */
    private final float[] path = new float[Layout.LAYERED_PATH_LENGTH];

    private final float[] scratch = new float[Layout.LAYERED_SCRATCH_LENGTH];

    private int left;
    private int top;
    private int samples;
    private boolean stores;

    /** Whether all rays are view rays. */
    private boolean isFirst;

    /** Shares the tile and the hits of the same thread. */
    PathTile(TileMemory bench, BounceRenderer bounces) {
        this.bench = bench;
        this.bounces = bounces;
    }

    /** Renders the tile's pixels that lie in the frame, until the frame is stopped. */
    void draw(Drawing drawing) {
        begin(drawing, Tile.SIZE, drawing.pixelSamples, true);
        while (goesOn() && !drawing.stop.isAsked()) {
            step(drawing);
        }
    }

    /**
     * Begins with the first samples of the tile's first pixels.
     *
     * @param pixels limit of their number
     * @param isStored whether the pixels are stored in the frame
     */
    void begin(Drawing drawing, int pixels, int newSamples, boolean isStored) {
        left = bench.tile.left;
        top = bench.tile.top;
        samples = newSamples;
        stores = isStored;
        isFirst = true;
        columns.take(drawing.input, drawing.input.variant(drawing.frame.isLinear()));
        slots.clear();
        for (int pixel = 0; pixel < Tile.SIZE && slots.count < pixels; pixel++) {
            if (left + Tile.column(pixel) < drawing.width && top + Tile.row(pixel) < drawing.rows) {
                slots.add(pixel, !drawing.declined.areHits());
            }
        }
    }

    boolean goesOn() {
        return slots.count > 0;
    }

    /** Follows one ray of each path. */
    void step(Drawing drawing) {
        start();
        int found = slots.together >= Lanes.COUNT ? slots.together : 0;
        if (found > 0) {
            findTogether(drawing);
        }
        findApart(found);
        isFirst = false;
        arrive();
        light();
        for (int slot = 0; slot < slots.count; slot++) {
            end(drawing, slot, isInGlass(drawing, slots.hit[slot]));
        }
        slots.sort();
    }

    /** Starts the view rays of paths that have none. */
    private void start() {
        int count = 0;
        for (int packet = 0; packet * Lanes.COUNT < slots.count; packet++) {
            long lanes = lanes(packet, 0, PathTracer.NO_RAY);
            columns.activate(packet, lanes);
            packets[count] = packet;
            count += lanes == 0 ? 0 : 1;
        }
        for (int slot = 0; slot < slots.count; slot++) {
            if (slots.ray[slot] == PathTracer.NO_RAY) {
                columns.ints[columns.intAt(slot, FIRST)] = left + Tile.column(slots.pixel[slot]);
                columns.ints[columns.intAt(slot, FIRST + 1)] = top + Tile.row(slots.pixel[slot]);
                columns.ints[columns.intAt(slot, FIRST + 2)] = slots.sample[slot];
                slots.ray[slot] = PathTracer.TO_SURFACE;
            }
        }
        if (count > 0) {
            StartLanes.run(columns, packets, count);
        }
    }

    /** The packet's lanes that hold slots from a first one on with that kind of ray. */
    private long lanes(int packet, int first, int ray) {
        long lanes = 0;
        int begin = packet * Lanes.COUNT;
        int end = Math.min(begin + Lanes.COUNT, slots.count);
        for (int slot = Math.max(begin, first); slot < end; slot++) {
            lanes |= slots.ray[slot] == ray ? 1L << (slot - begin) : 0;
        }
        return lanes;
    }

    private void findTogether(Drawing drawing) {
        Tile tile = bench.tile;
        float[] t = tile.values;
        tile.left = left;
        tile.top = top;
        tile.live.clear();
        int end = (slots.together + Lanes.COUNT - 1) / Lanes.COUNT * Lanes.COUNT;
        for (int slot = 0; slot < end; slot += Lanes.COUNT) {
            tile.live.add(slot);
            for (int axis = 0; axis < 3; axis++) {
                load(slot, Layout.ORIGIN + axis, Tile.ORIGIN_X + axis * Tile.SIZE);
                load(slot, Layout.DIRECTION + axis, Tile.DIRECTION_X + axis * Tile.SIZE);
            }
            load(slot, Layout.LEAVING, Tile.LEAVING);
            load(slot, Layout.LEAVING_TRIANGLE, Tile.LEAVING_TRIANGLE);
            load(slot, Layout.INSIDE, Tile.INSIDE);
        }
        for (int slot = 0; slot < end; slot++) {
            t[slot + Tile.THROUGHPUT] = slot < slots.together ? 1f : 0f;
        }
        if (isFirst && !drawing.crowded && !drawing.lens) {
            bench.choices.cullViewRays(drawing, tile);
        }
        bounces.findHits(drawing, tile, isFirst ? 0 : 1, false);
        for (int slot = 0; slot < slots.together; slot++) {
            int hit = (int) t[slot + Tile.HIT];
            float distance = hit == Layout.NOTHING ? Intersection.MISS : t[slot + Tile.DISTANCE];
            columns.floats[columns.floatAt(slot, Layout.DISTANCE)] = distance;
            columns.floats[columns.floatAt(slot, Layout.INSTANCE)] = t[slot + Tile.INSTANCE];
            columns.floats[columns.floatAt(slot, Layout.TRIANGLE)] = t[slot + Tile.TRIANGLE];
            boolean passes = slots.ray[slot] == PathTracer.TO_EMITTER
                    && distance >= columns.floats[columns.floatAt(slot, Layout.LIGHT_DISTANCE)];
            slots.hit[slot] = passes ? Layout.NOTHING : hit;
        }
    }

    private void load(int slot, int column, int tileColumn) {
        System.arraycopy(
                columns.floats, columns.floatAt(slot, column), bench.tile.values, slot + tileColumn, Lanes.COUNT);
    }

    /** Finds the hits of the slots from a first one on, without packets. */
    private void findApart(int first) {
        int count = 0;
        for (int packet = first / Lanes.COUNT; packet * Lanes.COUNT < slots.count; packet++) {
            long lanes = lanes(packet, first, PathTracer.TO_SURFACE) | lanes(packet, first, PathTracer.TO_EMITTER);
            columns.activate(packet, lanes);
            packets[count] = packet;
            count += lanes == 0 ? 0 : 1;
        }
        if (count > 0) {
            for (int slot = first; slot < slots.count; slot++) {
                columns.ints[columns.intAt(slot, FIRST)] = slots.ray[slot];
            }
            FindLanes.run(columns, packets, count);
            for (int slot = first; slot < slots.count; slot++) {
                slots.hit[slot] = columns.ints[columns.intAt(slot, PathColumns.RESULT)];
            }
        }
    }

    private void arrive() {
        int count = activate(PathTracer.TO_SURFACE);
        if (count > 0) {
            ArriveLanes.run(columns, packets, count);
            takeRays(PathTracer.TO_SURFACE);
        }
    }

    private void light() {
        int count = activate(PathTracer.TO_EMITTER);
        if (count > 0) {
            LightLanes.run(columns, packets, count);
            takeRays(PathTracer.TO_EMITTER);
        }
    }

    /** Lists the packets that have rays of a kind, and passes what they have met. */
    private int activate(int ray) {
        int count = 0;
        for (int packet = 0; packet * Lanes.COUNT < slots.count; packet++) {
            long lanes = lanes(packet, 0, ray);
            columns.activate(packet, lanes);
            packets[count] = packet;
            count += lanes == 0 ? 0 : 1;
        }
        for (int slot = 0; slot < slots.count; slot++) {
            if (slots.ray[slot] == ray) {
                columns.ints[columns.intAt(slot, FIRST)] = slots.hit[slot];
                columns.ints[columns.intAt(slot, FIRST + 1)] = slots.bounce[slot];
            }
        }
        return count;
    }

    /** Takes what the rays after those of a kind are. */
    private void takeRays(int ray) {
        for (int slot = 0; slot < slots.count; slot++) {
            if (slots.ray[slot] == ray) {
                slots.next[slot] = columns.ints[columns.intAt(slot, PathColumns.RESULT)];
            }
        }
    }

    /** Goes on with a path's next ray, or with the pixel's next sample, or stores the pixel. */
    private void end(Drawing drawing, int slot, boolean isApart) {
        slots.bounce[slot] += slots.ray[slot] == PathTracer.TO_SURFACE ? 1 : 0;
        if (slots.next[slot] != PathTracer.NO_RAY) {
            slots.goOn(slot, slots.next[slot], isApart);
        } else if (slots.sample[slot] + 1 < samples) {
            slots.restart(slot, slots.sample[slot] + 1, !drawing.declined.areHits());
        } else {
            if (stores) {
                store(drawing, slot);
            }
            slots.end(slot);
        }
    }

    private void store(Drawing drawing, int slot) {
        columns.copy(slot, path, scratch);
        PixelKernel.store(
                left + Tile.column(slots.pixel[slot]),
                top + Tile.row(slots.pixel[slot]),
                drawing.frame.argb(),
                drawing.frame.radiance(),
                drawing.frame.layers(),
                path,
                scratch,
                drawing.input.view().frame(),
                drawing.input.variant(drawing.frame.isLinear()));
    }

    /** Whether the path may be inside a body whose far side packets do not see: one that transmits, in a crowd. */
    private static boolean isInGlass(Drawing drawing, int hit) {
        return drawing.crowded && hit > Layout.NOTHING && drawing.looks.transmits(hit);
    }
}
