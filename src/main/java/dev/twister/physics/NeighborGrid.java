package dev.twister.physics;

import java.util.Arrays;

/**
 * A hashed grid in levels: each body is in the level whose cells are just wider than twice its reach, so that whatever
 * it may touch is, in that level and in all coarser ones, in its own cell or in one beside it (Ericson, "Real-Time
 * Collision Detection", 7.2). Cells side by side along x are side by side in memory, and their neighbors not far.
 *
 * <p>Bodies are in the cells in the order of their numbers, so that nothing depends on how many threads work.
 */
final class NeighborGrid {
    /** Odd numbers without a pattern: no two cells near each other have one key. */
    private static final int Y_FACTOR = 0x9E3779B1;

    private static final int Z_FACTOR = 0x85EBCA77;
    private static final int LEVEL_FACTOR = 0xC2B2AE3D;
    private static final int MIDDLE_LEVEL = 32;
    private static final int LEVELS = 64;
    private static final int MIN_BUCKETS = 1 << 10;
    private static final int BUCKETS_FOR_A_BODY = 4;

    /** More than any bucket holds, but where bodies lie in one another. */
    private static final int SLOTS_AT_ONCE = 1024;

    /**
     * What floats may lose of a reach, of coordinates and of squares of both: more is added, so that no pair is lost.
     */
    private static final double ROUNDED_REACH = 1 + 0x1p-20;

    private static final double ROUNDED_COORDINATE = 0x1p-23;

    private static final boolean WIDE = canScanWide();

    private final BodyStore bodies;
    private final double baseCell;
    private final double[] cells = new double[LEVELS];
    private final int[] keyOfBody;
    private final int[] bucketOfBody;
    private final byte[] levelOfBody;
    private final int[] inLevel = new int[LEVELS];
    private int[] starts = {};

    /** By bucket: 1 where a body of that level is in the cell or beside it. Most cells of coarse levels have none. */
    private byte[] near = {};

    /** The same of bodies that are awake. */
    private byte[] awakeNear = {};

    private int finestLevel;
    private int mask;

    /** Buckets from a cell to the one above it, and to the one behind it. */
    private int rowStride = 1;

    private int layerStride = 1;

    private double largestRounding;

    /**
     * By slot, which is the order of the cells: the body, its cell's key, its center, its reach (below 0 asleep). As
     * few bits as do, for a search waits for memory.
     */
    final int[] body;

    final int[] key;
    final float[] x;
    final float[] y;
    final float[] z;
    final float[] reach;
    int from;
    int slots;

    /** The bits of a slot that are all set where the scan for it is a wide one: 0 where all are, -1 where none is. */
    private int wideSlots;

    private int wideSearches;

    /** The coarsest level whose bodies are many; those above it are giants, whose pairs are sought one by one. */
    int topLevel;

    NeighborGrid(BodyStore bodies, double typicalReach) {
        this.bodies = bodies;
        baseCell = 2 * typicalReach;
        for (int level = 0; level < LEVELS; level++) {
            cells[level] = Math.scalb(baseCell, level - MIDDLE_LEVEL);
        }
        int room = bodies.state.length;
        keyOfBody = new int[room];
        bucketOfBody = new int[room];
        levelOfBody = new byte[room];
        // The last slots too may be read by whole vectors.
        body = new int[room + WideScan.LANES];
        key = new int[room + WideScan.LANES];
        x = new float[room + WideScan.LANES];
        y = new float[room + WideScan.LANES];
        z = new float[room + WideScan.LANES];
        reach = new float[room + WideScan.LANES];
        if (room > WideScan.MIN_SLOTS && WIDE) {
            // Loads the classes now: within a step that would be felt.
            WideScan.scan(this, 0, 0, WideScan.LANES, 0, -1, new Contacts());
        }
    }

    /** How far the two bodies of a pair without a giant are apart at most, along an axis, in meters. */
    double farthestPair() {
        return cells[topLevel] * ROUNDED_REACH * ROUNDED_REACH + 4 * largestRounding;
    }

    int level(int slot) {
        return levelOfBody[body[slot]];
    }

    /**
     * Lays the buckets out for bodies within some bounds; others are found too, but share buckets with them.
     *
     * @param bounds least and largest x, y, z, in meters
     */
    void layOut(double[] bounds) {
        int buckets = Math.max(MIN_BUCKETS, Integer.highestOneBit(Math.max(1, bodies.count)) * BUCKETS_FOR_A_BODY);
        if (starts.length != buckets + 1) {
            starts = new int[buckets + 1];
            near = new byte[buckets];
            awakeNear = new byte[buckets];
        }
        mask = buckets - 1;
        // The base level has most of the bodies.
        rowStride = (int) Math.clamp((bounds[1] - bounds[0]) / baseCell + 2, 3, buckets / 3.0);
        layerStride = (int) Math.clamp(rowStride * ((bounds[3] - bounds[2]) / baseCell + 2), rowStride, buckets);
        largestRounding = rounding(
                farthest(bounds[0], bounds[1]), farthest(bounds[2], bounds[3]), farthest(bounds[4], bounds[5]));
    }

    // From 0, also where there is nothing within the bounds.
    private static double farthest(double least, double largest) {
        return Math.max(0, Math.max(-least, largest));
    }

    private static double rounding(double px, double py, double pz) {
        return (Math.abs(px) + Math.abs(py) + Math.abs(pz)) * ROUNDED_COORDINATE;
    }

    /** Finds a body's level and cell; its reach and its position must stand. */
    void locate(int number) {
        int at = BodyStore.STRIDE * number;
        double ratio = 2 * bodies.reach[number] / baseCell;
        int exponent = Math.getExponent(ratio);
        int steps = ratio > Math.scalb(1.0, exponent) ? exponent + 1 : exponent;
        int level = Math.clamp(steps + (long) MIDDLE_LEVEL, 0, LEVELS - 1);
        levelOfBody[number] = (byte) level;
        double px = bodies.numbers[at + BodyStore.POSITION];
        double py = bodies.numbers[at + BodyStore.POSITION + 1];
        double pz = bodies.numbers[at + BodyStore.POSITION + 2];
        keyOfBody[number] = cellKey(px, py, pz, level);
        bucketOfBody[number] = bucket(px, py, pz, level);
    }

    /**
     * Sorts the bodies into the cells.
     *
     * @param first the first body that counts
     * @param giants how many bodies may be looked after one by one
     */
    void sort(int first, int giants) {
        from = first;
        slots = bodies.count - first;
        wideSlots = wideSlots();
        int buckets = mask + 1;
        Arrays.fill(starts, 0);
        Arrays.fill(near, (byte) 0);
        Arrays.fill(awakeNear, (byte) 0);
        Arrays.fill(inLevel, 0);
        for (int number = first; number < bodies.count; number++) {
            starts[bucketOfBody[number] + 1]++;
            inLevel[levelOfBody[number]]++;
        }
        for (int bucket = 0; bucket < buckets; bucket++) {
            starts[bucket + 1] += starts[bucket];
        }
        // Filled from the end, so that afterwards each start is where it belongs, and the order is kept.
        for (int number = bodies.count - 1; number >= first; number--) {
            body[--starts[bucketOfBody[number] + 1]] = number;
        }
        System.arraycopy(starts, 1, starts, 0, buckets);
        starts[buckets] = slots;
        finestLevel = 0;
        while (finestLevel < LEVELS - 1 && inLevel[finestLevel] == 0) {
            finestLevel++;
        }
        topLevel = LEVELS - 1;
        int above = 0;
        while (topLevel > 0 && above + inLevel[topLevel] <= giants) {
            above += inLevel[topLevel];
            topLevel--;
        }
    }

    /** A JVM that was started without the Vector API has no such lanes. */
    private static boolean canScanWide() {
        try {
            return WideScan.SUITS;
        } catch (NoClassDefFoundError _) {
            return false;
        }
    }

    // A few slots' wide scans let the compiler get ready: until then each takes 10 to 40 microseconds.
    private int wideSlots() {
        if (slots < WideScan.MIN_SLOTS || !WIDE) {
            return -1;
        }
        if (wideSearches < WideScan.FIRST_SEARCHES) {
            wideSearches++;
            int wide = 1 << (wideSearches / WideScan.SEARCHES_TO_DOUBLE);
            return Integer.highestOneBit(Math.max(1, slots / wide)) - 1;
        }
        return 0;
    }

    /** Copies what a search reads of the bodies of some slots. */
    void gather(int fromSlot, int toSlot) {
        double[] numbers = bodies.numbers;
        // The bodies of a bucket follow each other.
        int announced = -1;
        int announcedAwake = -1;
        for (int slot = fromSlot; slot < toSlot; slot++) {
            int number = body[slot];
            int at = BodyStore.STRIDE * number;
            key[slot] = keyOfBody[number];
            double px = numbers[at + BodyStore.POSITION];
            double py = numbers[at + BodyStore.POSITION + 1];
            double pz = numbers[at + BodyStore.POSITION + 2];
            x[slot] = (float) px;
            y[slot] = (float) py;
            z[slot] = (float) pz;
            float far = (float) (bodies.reach[number] * ROUNDED_REACH + rounding(px, py, pz));
            reach[slot] = bodies.state[number] == BodyStore.ASLEEP ? -far : far;
            int bucket = bucketOfBody[number];
            boolean coarse = levelOfBody[number] > finestLevel && levelOfBody[number] <= topLevel;
            if (coarse && bucket != announced) {
                announce(near, bucket);
                announced = bucket;
            }
            if (reach[slot] > 0 && bucket != announcedAwake) {
                announce(awakeNear, bucket);
                announcedAwake = bucket;
            }
        }
    }

    // Threads may write one place at once, but all write the same.
    private void announce(byte[] marks, int bucket) {
        for (int dz = -1; dz <= 1; dz++) {
            for (int dy = -1; dy <= 1; dy++) {
                int row = bucket + dz * layerStride + dy * rowStride;
                marks[(row - 1) & mask] = 1;
                marks[row & mask] = 1;
                marks[(row + 1) & mask] = 1;
            }
        }
    }

    boolean isGiant(int slot) {
        return level(slot) > topLevel;
    }

    /**
     * Adds the pairs of a slot's body with bodies that come after it in its own level, and with all in coarser levels
     * up to the top one.
     */
    void addPairs(int slot, Contacts contacts) {
        if (reach[slot] > 0 || awakeNear[bucketOfBody[body[slot]]] != 0) {
            addPairsOfOwnLevel(slot, contacts);
        }
        for (int level = level(slot) + 1; level <= topLevel; level++) {
            if (inLevel[level] > 0) {
                addPairsOfLevel(slot, level, contacts);
            }
        }
    }

    private void addPairsOfOwnLevel(int slot, Contacts contacts) {
        int own = key[slot];
        int bucket = bucketOfBody[body[slot]];
        if (bucket < mask) {
            // The rest of its own cell, and the next one.
            scan(slot, slot + 1, starts[bucket + 2], own, 1, contacts);
        } else {
            scan(slot, slot + 1, starts[bucket + 1], own, 0, contacts);
            scanBucket(slot, own + 1, bucket + 1, contacts);
        }
        int left = bucket - 1;
        scanRow(slot, own + Y_FACTOR - 1, left + rowStride, contacts);
        scanRow(slot, own + Z_FACTOR - 1, left + layerStride, contacts);
        scanRow(slot, own + Z_FACTOR + Y_FACTOR - 1, left + layerStride + rowStride, contacts);
        scanRow(slot, own + Z_FACTOR - Y_FACTOR - 1, left + layerStride - rowStride, contacts);
    }

    private void addPairsOfLevel(int slot, int level, Contacts contacts) {
        int at = BodyStore.STRIDE * body[slot] + BodyStore.POSITION;
        double px = bodies.numbers[at];
        double py = bodies.numbers[at + 1];
        double pz = bodies.numbers[at + 2];
        int bucket = bucket(px, py, pz, level);
        if (near[bucket] == 0 || (reach[slot] < 0 && awakeNear[bucket] == 0)) {
            return;
        }
        int middle = cellKey(px, py, pz, level);
        for (int dz = -1; dz <= 1; dz++) {
            for (int dy = -1; dy <= 1; dy++) {
                int firstKey = middle + dz * Z_FACTOR + dy * Y_FACTOR - 1;
                scanRow(slot, firstKey, bucket + dz * layerStride + dy * rowStride - 1, contacts);
            }
        }
    }

    /** Adds the pairs of a giant with everything, other giants after it only. */
    void addGiantsPairs(int slot, Contacts contacts) {
        int start = contacts.count;
        // Every key is within that span.
        scan(slot, 0, slots, 0, -1, contacts);
        contacts.keep(start, other -> other != body[slot] && (levelOfBody[other] <= topLevel || other > body[slot]));
    }

    private void scanRow(int slot, int firstKey, int firstBucket, Contacts contacts) {
        int bucket = firstBucket & mask;
        if (bucket + 3 <= mask + 1) {
            scan(slot, starts[bucket], starts[bucket + 3], firstKey, 2, contacts);
        } else {
            scanBucket(slot, firstKey, bucket, contacts);
            scanBucket(slot, firstKey + 1, bucket + 1, contacts);
            scanBucket(slot, firstKey + 2, bucket + 2, contacts);
        }
    }

    private void scanBucket(int slot, int wanted, int unwrapped, Contacts contacts) {
        int bucket = unwrapped & mask;
        scan(slot, starts[bucket], starts[bucket + 1], wanted, 0, contacts);
    }

    private void scan(int slot, int start, int end, int firstKey, int span, Contacts contacts) {
        if (end - start <= SLOTS_AT_ONCE) {
            scanSome(slot, start, end, firstKey, span, contacts);
        } else {
            for (int first = start; first < end && !contacts.isFull(); first += SLOTS_AT_ONCE) {
                scanSome(slot, first, Math.min(end, first + SLOTS_AT_ONCE), firstKey, span, contacts);
            }
        }
    }

    // Buckets hold other cells' bodies too: the keys tell. Without a branch for the distance, which nothing could
    // predict.
    private void scanSome(int slot, int start, int end, int firstKey, int span, Contacts contacts) {
        if ((slot & wideSlots) == wideSlots) {
            WideScan.scan(this, slot, start, end, firstKey, span, contacts);
            return;
        }
        float px = x[slot];
        float py = y[slot];
        float pz = z[slot];
        float own = Math.abs(reach[slot]);
        boolean awake = reach[slot] > 0;
        int[] found = contacts.roomFor(end - start);
        int count = contacts.count;
        for (int other = start; other < end; other++) {
            if (Integer.compareUnsigned(key[other] - firstKey, span) <= 0 && (awake || reach[other] > 0)) {
                float dx = px - x[other];
                float dy = py - y[other];
                float dz = pz - z[other];
                float sum = own + Math.abs(reach[other]);
                found[count] = body[other];
                // The sign, as a number.
                int apart = Float.floatToRawIntBits(sum * sum - (dx * dx + dy * dy + dz * dz)) >> (Integer.SIZE - 1);
                count += 1 + apart;
            }
        }
        contacts.addFound(count);
    }

    private int cellKey(double px, double py, double pz, int level) {
        double cell = cells[level];
        return index(px, cell) + index(py, cell) * Y_FACTOR + index(pz, cell) * Z_FACTOR + level * LEVEL_FACTOR;
    }

    private int bucket(double px, double py, double pz, int level) {
        double cell = cells[level];
        int linear =
                index(px, cell) + index(py, cell) * rowStride + index(pz, cell) * layerStride + level * LEVEL_FACTOR;
        return linear & mask;
    }

    // Its last bits, where a world is as large as that.
    private static int index(double place, double cell) {
        return (int) (long) Math.floor(place / cell);
    }
}
