package dev.twister.world.hierarchy;

/**
 * Boxes in the order of a hierarchy's leaves.
 *
 * @param sides minimum x, y, z and maximum x, y, z of each
 * @param numbers the numbers of the boxes in this order
 */
@SuppressWarnings("ArrayRecordComponent") // reordered in place
record Boxes(float[] sides, int[] numbers) {
    /** Instead of an axis: the sum of a box's extents. */
    static final int SIZE = 3;

    /**
     * Partitions a range at the border of the bins at which a split costs least.
     *
     * @param axis 0 for x, 1 for y, 2 for z, or {@link #SIZE}
     * @param bins filled with the range by this axis
     * @return start of the second part
     */
    int part(int start, int end, int axis, Bins bins) {
        int border = bins.findBorder();
        int head = start;
        int tail = end - 1;
        while (head <= tail) {
            if (bins.bin(coordinate(head, axis)) < border) {
                head++;
            } else {
                swap(head, tail);
                tail--;
            }
        }
        return head;
    }

    /** Adds a box to the bins by an axis, as the box of so many spheres. */
    void add(int box, int spheres, int axis, Bins bins) {
        bins.add(bins.bin(coordinate(box, axis)), spheres, sides, 6 * box);
    }

    /** The coordinate of a box's center along an axis, or the box's {@link #SIZE}. */
    float coordinate(int box, int axis) {
        int at = 6 * box;
        return axis == SIZE
                ? sides[at + 3] - sides[at] + sides[at + 4] - sides[at + 1] + sides[at + 5] - sides[at + 2]
                : Bounds.middle(sides, at + axis);
    }

    void swap(int one, int other) {
        for (int i = 0; i < 6; i++) {
            float side = sides[6 * one + i];
            sides[6 * one + i] = sides[6 * other + i];
            sides[6 * other + i] = side;
        }
        int number = numbers[one];
        numbers[one] = numbers[other];
        numbers[other] = number;
    }
}
