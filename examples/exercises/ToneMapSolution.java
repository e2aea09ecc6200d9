/** Exercise of lesson 3, solved: Reinhard's extended tone map. */
final class ToneMapSolution {
    private static final double WHITE = 4;

    private ToneMapSolution() {}

    /** What is shown of a linear color, in [0, 1]. */
    static double shown(double color) {
        return Math.min(color * (1 + color / (WHITE * WHITE)) / (1 + color), 1);
    }
}
