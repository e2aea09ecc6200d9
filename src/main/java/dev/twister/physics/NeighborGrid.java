package dev.twister.physics;

import java.util.Arrays;

/**
 * A hashed hierarchical grid. Each body is in the finest level whose cells are at least twice as wide as its reach, so
 * that its possible contacts in that level and in all coarser ones are in its own cell or an adjacent one (Ericson,
 * "Real-Time Collision Detection", 7.2). Cells adjacent along x are adjacent in memory, and their neighbors close.
 *
 * <p>Bodies are in the cells in the order of their numbers, so the result does not depend on the number of threads.
 */
final class NeighborGrid {
    /** Odd hash factors: no two nearby cells have equal keys. */
    private static final int Y_FACTOR = 0x9E3779B1;

    private static final int Z_FACTOR = 0x85EBCA77;
    private static final int LEVEL_FACTOR = 0xC2B2AE3D;
    private static final int MIDDLE_LEVEL = 32;
    private static final int LEVELS = 64;
    private static final int MIN_BUCKETS = 1 << 10;
    private static final int BUCKETS_FOR_A_BODY = 4;

    /** More slots than a bucket has, unless bodies overlap. */
    private static final int SLOTS_AT_ONCE = 1024;

    /** Margins for the rounding of reach, coordinates and squares in floats, so that no pair is lost. */
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

    /**
     * Per bucket: 1 if a body of that level is in the cell or an adjacent one. Most cells of coarse levels have none.
     */
    private byte[] near = {};

    /** The same for awake bodies. */
    private byte[] awakeNear = {};

    private int finestLevel;
    private int mask;

    /** Distance in buckets to the cell above and to the cell behind. */
    private int rowStride = 1;

    private int layerStride = 1;

    private double largestRounding;

    /**
     * Per slot, in the order of the cells: the body, its cell's key, its center, and its reach (negative while asleep).
     * Small types, because the search is limited by memory bandwidth.
     */
    final int[] body;

    final int[] key;
    final float[] x;
    final float[] y;
    final float[] z;
    final float[] reach;
    int from;
    int slots;

    /** Mask of slot bits that must all be set for a wide scan: 0 for every slot, -1 for none. */
    private int wideSlots;

    private int wideSearches;

    /** The coarsest level with many bodies. Bodies above it are giants, whose pairs are searched one by one. */
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
        // Padding: the last slots may be read by whole vectors.
        body = new int[room + WideScan.LANES];
        key = new int[room + WideScan.LANES];
        x = new float[room + WideScan.LANES];
        y = new float[room + WideScan.LANES];
        z = new float[room + WideScan.LANES];
        reach = new float[room + WideScan.LANES];
        if (room > WideScan.MIN_SLOTS && WIDE) {
            // Loads the classes now, because it would be noticeable within a step.
            WideScan.scan(this, 0, 0, WideScan.LANES, 0, -1, new Contacts());
        }
    }

    /** Largest distance along an axis between the bodies of a pair without a giant, in meters. */
    double farthestPair() {
        return cells[topLevel] * ROUNDED_REACH * ROUNDED_REACH + 4 * largestRounding;
    }

    int level(int slot) {
        return levelOfBody[body[slot]];
    }

    /**
     * Lays out the buckets for bodies within the bounds. Bodies outside are found too, but share buckets with others.
     *
     * @param bounds minimum and maximum of x, y and z, in meters
     */
    void layOut(double[] bounds) {
        int buckets = Math.max(MIN_BUCKETS, Integer.highestOneBit(Math.max(1, bodies.count)) * BUCKETS_FOR_A_BODY);
        if (starts.length != buckets + 1) {
            starts = new int[buckets + 1];
            near = new byte[buckets];
            awakeNear = new byte[buckets];
        }
        mask = buckets - 1;
        // Most bodies are in the base level.
        rowStride = (int) Math.clamp((bounds[1] - bounds[0]) / baseCell + 2, 3, buckets / 3.0);
        layerStride = (int) Math.clamp(rowStride * ((bounds[3] - bounds[2]) / baseCell + 2), rowStride, buckets);
        largestRounding = rounding(
                farthest(bounds[0], bounds[1]), farthest(bounds[2], bounds[3]), farthest(bounds[4], bounds[5]));
    }

    // At least 0, even if nothing is within the bounds.
    private static double farthest(double least, double largest) {
        return Math.max(0, Math.max(-least, largest));
    }

    private static double rounding(double px, double py, double pz) {
        return (Math.abs(px) + Math.abs(py) + Math.abs(pz)) * ROUNDED_COORDINATE;
    }

    /** Computes a body's level and cell from its reach and position. */
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
     * @param first the first body to include
     * @param giants how many bodies may be treated as giants
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
        // Filled from the end, so that each start ends up in place and the order is stable.
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

    /** False in a JVM without the Vector API. */
    private static boolean canScanWide() {
        try {
            return WideScan.SUITS;
        } catch (NoClassDefFoundError _) {
            return false;
        }
    }

    // At first only a few slots use wide scans, while each takes 10 to 40 microseconds until it is compiled.
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

    /** Copies the data that a search reads to a range of slots. */
    void gather(int fromSlot, int toSlot) {
        double[] numbers = bodies.numbers;
        // The bodies of a bucket are contiguous.
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

    // Threads may write the same element concurrently, but all write the same value.
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
     * Adds the pairs of a slot's body with later bodies of its own level, and with all bodies of coarser levels up to
     * the top one.
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
            // The rest of its own cell, and the next cell.
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

    /** Adds the pairs of a giant with all bodies, but only with later giants. */
    void addGiantsPairs(int slot, Contacts contacts) {
        int start = contacts.count;
        // This span includes all keys.
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

    // A bucket may hold bodies of other cells, so keys are compared. The distance test has no branch, because it would
    // be
    // unpredictable.
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
                // The sign bit as 0 or -1.
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

    // The lowest bits, in case the world is that large.
    private static int index(double place, double cell) {
        return (int) (long) Math.floor(place / cell);
    }
}
