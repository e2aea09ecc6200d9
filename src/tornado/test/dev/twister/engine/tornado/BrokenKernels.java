package dev.twister.engine.tornado;

import uk.ac.manchester.tornado.api.annotations.Parallel;

/** Kernels that TornadoVM cannot compile or that render nothing. (Recursion would make its compiler loop.) */
final class BrokenKernels {
    private BrokenKernels() {}

    private record Point(int x, int y) {}

    static void keepingObjects(
            int[] pixels,
            float[] radiance,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int width,
            int rows,
            int variant) {
        for (@Parallel int i = 0; i < rows; i++) {
            Point kept = new Point(0, 0);
            for (int x = 0; x < frame[0]; x++) {
                if (bodies[x % 3] > 0) {
                    kept = new Point(x, kept.y() + 1);
                }
            }
            pixels[i] = kept.x() + kept.y();
        }
    }

    /** Compiles, but renders nothing. */
    static void idle(
            int[] pixels,
            float[] radiance,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int width,
            int rows,
            int variant) {
        for (@Parallel int i = 0; i < rows; i++) {
            if (i < rows / 2) {
                pixels[i * width] = -1;
            }
        }
    }
}
