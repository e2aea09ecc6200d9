import dev.twister.scene.Triangles;

/** Exercise of lesson 11, solved. */
final class ShapeSolution {
    private ShapeSolution() {}

    /** An upright prism about the origin, closed at both ends. */
    static Triangles prism(int sides, double height) {
        float[] positions = new float[6 * sides];
        int[] corners = new int[3 * (4 * sides - 4)];
        int used = 0;
        for (int side = 0; side < sides; side++) {
            // The floor's corners have even numbers, the ceiling's odd ones.
            double angle = 2 * Math.PI * side / sides;
            for (int end = 0; end < 2; end++) {
                positions[6 * side + 3 * end] = (float) Math.cos(angle);
                positions[6 * side + 3 * end + 1] = (float) (height * (end - 0.5));
                positions[6 * side + 3 * end + 2] = (float) Math.sin(angle);
            }
            int here = 2 * side;
            int next = 2 * ((side + 1) % sides);
            used = put(corners, used, here, here + 1, next);
            used = put(corners, used, next, here + 1, next + 1);
            if (side > 0 && side < sides - 1) {
                used = put(corners, used, 0, here, next);
                used = put(corners, used, 1, next + 1, here + 1);
            }
        }
        return Triangles.of("prism", positions, corners);
    }

    private static int put(int[] corners, int used, int a, int b, int c) {
        corners[used] = a;
        corners[used + 1] = b;
        corners[used + 2] = c;
        return used + 3;
    }
}
