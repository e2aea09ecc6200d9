import dev.twister.scene.Triangles;

/** Exercise of lesson 11: a shape of triangles. */
final class ShapeAttempt {
    private ShapeAttempt() {}

    /**
     * An upright prism about the origin, closed at both ends.
     *
     * @param sides of its floor, a regular polygon whose corners lie 1 m from the axis, the first in the direction of x
     * @param height in meters
     */
    static Triangles prism(int sides, double height) {
        float low = (float) (-height / 2);
        float[] positions = {1, low, 0, 0, low, 1, -1, low, 0};
        int[] corners = {0, 1, 2};
        return Triangles.of("prism", positions, corners);
    }
}
