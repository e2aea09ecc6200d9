package dev.twister.kernel;

/**
 * Directions of the sky, chosen in proportion to its luminance. The table has the sums of the probabilities of the rows
 * from the top, then for each row those of its texels from the left, each up to and including the entry.
 */
final class SkyTable {
    /** Lower bound of the cosine of an elevation: texels at the poles are slivers. */
    private static final float LEAST_COSINE = 1e-7f;

    private SkyTable() {}

    /**
     * Writes a direction to {@link Layout#TO_LIGHT} and its density per steradian to {@link Layout#LIGHT_DENSITY}.
     *
     * @param first chooses the column
     * @param second chooses the row
     */
    static void choose(float[] path, float first, float second, float[] frame, float[] images) {
        int width = (int) frame[Layout.SKY_WIDTH];
        int height = (int) frame[Layout.SKY_HEIGHT];
        int rows = Layout.ALIGNMENT * (int) frame[Layout.SKY_TABLE];
        int row = find(second, rows, height, images);
        int columns = rows + height + width * row;
        int column = find(first, columns, width, images);
        float rowBefore = before(rows, row, images);
        float rowPart = images[rows + row] - rowBefore;
        float columnBefore = before(columns, column, images);
        float columnPart = images[columns + column] - columnBefore;
        float toRight = columnPart > 0f ? Math.min((first - columnBefore) / columnPart, 1f) : 0f;
        float toBottom = rowPart > 0f ? Math.min((second - rowBefore) / rowPart, 1f) : 0f;
        float across = (column + toRight) / width + frame[Layout.SKY_TURN];
        float turns = across + 0.5f;
        turns = turns - KernelMath.floor(turns);
        float down = (row + toBottom) / height;
        // The elevation in turns is in [-1/4, 1/4].
        float y = KernelMath.cosineOfTurns(0.5f * down);
        float level = KernelMath.sineOfTurns(0.5f * down);
        path[Layout.TO_LIGHT] = level * KernelMath.sineOfTurns(turns);
        path[Layout.TO_LIGHT + 1] = y;
        path[Layout.TO_LIGHT + 2] = level * KernelMath.cosineOfTurns(turns);
        path[Layout.LIGHT_DENSITY] = perSteradian(rowPart * columnPart, level, width, height);
    }

    /** Density per steradian of the direction of the path's ray. */
    static float density(float[] path, float[] frame, float[] images) {
        int width = (int) frame[Layout.SKY_WIDTH];
        int height = (int) frame[Layout.SKY_HEIGHT];
        int rows = Layout.ALIGNMENT * (int) frame[Layout.SKY_TABLE];
        float x = path[Layout.DIRECTION];
        float y = path[Layout.DIRECTION + 1];
        float z = path[Layout.DIRECTION + 2];
        float across = SkyLookup.column(x, z, frame[Layout.SKY_TURN], width) + 0.5f;
        float down = SkyLookup.row(x, y, z, height) + 0.5f;
        int column = Math.min(Math.max(KernelMath.floor(across), 0), width - 1);
        int row = Math.min(Math.max(KernelMath.floor(down), 0), height - 1);
        int columns = rows + height + width * row;
        float rowPart = images[rows + row] - before(rows, row, images);
        float columnPart = images[columns + column] - before(columns, column, images);
        return perSteradian(rowPart * columnPart, (float) Math.sqrt(x * x + z * z), width, height);
    }

    /** {@code probability / solid angle}: a texel covers {@code 2 pi^2 cos(elevation) / (width * height)}. */
    private static float perSteradian(float probability, float cosine, int width, int height) {
        return probability
                * ((float) width * height)
                / (2f * KernelMath.PI * KernelMath.PI * Math.max(cosine, LEAST_COSINE));
    }

    /** The sum before an entry. */
    private static float before(int start, int entry, float[] images) {
        return entry > 0 ? images[start + entry - 1] : 0f;
    }

    /** The first entry whose sum is above the number. */
    private static int find(float number, int start, int count, float[] images) {
        int low = 0;
        int high = count - 1;
        while (low < high) {
            int middle = (low + high) / 2;
            int above = images[start + middle] <= number ? 1 : 0;
            low = above != 0 ? middle + 1 : low;
            high = above != 0 ? high : middle;
        }
        return low;
    }
}
