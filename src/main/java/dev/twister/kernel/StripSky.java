package dev.twister.kernel;

/** What the rays of a strip bring that end: at the sky, or at the light. */
final class StripSky {
    private StripSky() {}

    /** Adds the panorama where a ray has met nothing. */
    static void add(int pixels, float[] skybox, int[] skyboxDimensions, float[] lanes, int[] marks) {
        int width = skyboxDimensions[Layout.SKYBOX_WIDTH];
        int height = skyboxDimensions[Layout.SKYBOX_HEIGHT];
        for (int lane = 0; lane < pixels; lane++) {
            float x = lanes[Strip.DIRECTION_X + lane];
            float y = lanes[Strip.DIRECTION_Y + lane];
            float z = lanes[Strip.DIRECTION_Z + lane];
            lanes[Strip.SKY_COLUMN + lane] = SkyLookup.column(x, z, width);
            lanes[Strip.SKY_ROW + lane] = SkyLookup.row(x, y, z, height);
        }
        for (int lane = 0; lane < pixels; lane++) {
            if (marks[Strip.HIT + lane] == Layout.NOTHING) {
                float column = lanes[Strip.SKY_COLUMN + lane];
                float row = lanes[Strip.SKY_ROW + lane];
                float throughput = lanes[Strip.THROUGHPUT + lane];
                lanes[Strip.RED + lane] = lanes[Strip.RED + lane]
                        + throughput * SkyLookup.radiance(skybox, width, height, column, row, 0);
                lanes[Strip.GREEN + lane] = lanes[Strip.GREEN + lane]
                        + throughput * SkyLookup.radiance(skybox, width, height, column, row, 1);
                lanes[Strip.BLUE + lane] = lanes[Strip.BLUE + lane]
                        + throughput * SkyLookup.radiance(skybox, width, height, column, row, 2);
            }
        }
    }

    /** Adds the light's own colour where a ray has met the light. */
    static void addLight(int pixels, float[] bodyColors, float[] lanes, int[] marks) {
        float lightRed = bodyColors[3 * Layout.LIGHT];
        float lightGreen = bodyColors[3 * Layout.LIGHT + 1];
        float lightBlue = bodyColors[3 * Layout.LIGHT + 2];
        for (int lane = 0; lane < pixels; lane++) {
            float seen = marks[Strip.HIT + lane] == Layout.LIGHT ? lanes[Strip.THROUGHPUT + lane] : 0f;
            lanes[Strip.RED + lane] = lanes[Strip.RED + lane] + seen * lightRed;
            lanes[Strip.GREEN + lane] = lanes[Strip.GREEN + lane] + seen * lightGreen;
            lanes[Strip.BLUE + lane] = lanes[Strip.BLUE + lane] + seen * lightBlue;
        }
    }
}
