package dev.twister.engine.tornado;

import uk.ac.manchester.tornado.api.annotations.Parallel;
import uk.ac.manchester.tornado.api.types.arrays.FloatArray;
import uk.ac.manchester.tornado.api.types.arrays.IntArray;

/** Kernels that TornadoVM cannot compile or that render nothing. (Recursion would make its compiler loop.) */
final class BrokenKernels {
    private BrokenKernels() {}

    private record Point(int x, int y) {}

    static void keepingObjects(
            IntArray pixels,
            FloatArray radiance,
            float[] layers,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        for (@Parallel int i = 0; i < 8; i++) {
            Point kept = new Point(0, 0);
            for (int x = 0; x < frame[0]; x++) {
                if (bodies[x % 3] > 0) {
                    kept = new Point(x, kept.y() + 1);
                }
            }
            pixels.set(i, kept.x() + kept.y());
        }
    }

    /** Compiles, but renders nothing. */
    static void idle(
            IntArray pixels,
            FloatArray radiance,
            float[] layers,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        for (@Parallel int i = 0; i < 8; i++) {
            if (i < 4) {
                pixels.set(i, -1);
            }
        }
    }
}
