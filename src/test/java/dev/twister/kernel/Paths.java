package dev.twister.kernel;

import dev.twister.world.hierarchy.SphereHierarchy;
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

    /**
     * The array {@code frame} of a picture without ambient light, of bodies that are all present and of which none is a
     * mesh, with one sample per pixel whose numbers are 0.
     *
     * @param disc x and y of each shadow sample
     */
    static float[] frame(int bodies, float... disc) {
        float[] frame = new float[Layout.DISC + disc.length + Layout.SAMPLE_STRIDE];
        frame[Layout.BODIES] = bodies;
        frame[Layout.ROOT] = SphereHierarchy.root(bodies, bodies, 0);
        frame[Layout.SHADOW_ROOT] = frame[Layout.ROOT];
        frame[Layout.SHADOW_SAMPLES] = disc.length / 2f;
        frame[Layout.PIXEL_SAMPLES] = 1;
        System.arraycopy(disc, 0, frame, Layout.DISC, disc.length);
        frame[Layout.SAMPLES] = Layout.DISC + disc.length;
        return frame;
    }
}
