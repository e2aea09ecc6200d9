package dev.twister.kernel;

import java.util.Arrays;

/** Creates path arrays for tests of single steps. */
final class Paths {
    private Paths() {}

    /** A ray that leaves body {@code leaving}. */
    static float[] ray(float[] origin, float[] direction, int leaving) {
        float[] path = new float[Layout.PATH_LENGTH];
        System.arraycopy(origin, 0, path, Layout.ORIGIN, 3);
        System.arraycopy(direction, 0, path, Layout.DIRECTION, 3);
        path[Layout.LEAVING] = leaving;
        Arrays.fill(path, Layout.THROUGHPUT, Layout.THROUGHPUT + 3, 1f);
        return path;
    }

    /** A point whose normal points straight at the light. */
    static float[] lit(float[] point, float[] toLight, float lightDistance) {
        float[] path = new float[Layout.PATH_LENGTH];
        System.arraycopy(point, 0, path, Layout.POINT, 3);
        System.arraycopy(toLight, 0, path, Layout.TO_LIGHT, 3);
        System.arraycopy(toLight, 0, path, Layout.NORMAL, 3);
        path[Layout.LIGHT_DISTANCE] = lightDistance;
        path[Layout.NORMAL_DOT_LIGHT] = 1f;
        return path;
    }

    /** Properties of a picture with this number of shadow samples and no ambient light. */
    static float[] properties(int shadowSamples) {
        float[] properties = new float[Layout.PROPERTIES_LENGTH];
        properties[Layout.SHADOW_SAMPLES] = shadowSamples;
        return properties;
    }
}
