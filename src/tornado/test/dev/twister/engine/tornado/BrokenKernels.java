package dev.twister.engine.tornado;

import uk.ac.manchester.tornado.api.annotations.Parallel;

/** Kernels that TornadoVM cannot compile or that render nothing. (Recursion would make its compiler loop.) */
final class BrokenKernels {
    private BrokenKernels() {}

    private record Point(int x, int y) {}

    static void keepingObjects(
            int[] pixels,
            float[] radiance,
            int[] dimensions,
            float[] camera,
            float[] properties,
            float[] places,
            float[] looks,
            float[] hierarchy,
            float[] meshes,
            float[] sky,
            int[] skyDimensions,
            float[] shadowDisc,
            float[] pixelSamples,
            int width,
            int rows,
            int search,
            int firstMesh,
            int materials,
            int aspect,
            int output) {
        for (@Parallel int i = 0; i < rows; i++) {
            Point kept = new Point(0, 0);
            for (int x = 0; x < dimensions[0]; x++) {
                if (camera[x % 3] > 0) {
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
            int[] dimensions,
            float[] camera,
            float[] properties,
            float[] places,
            float[] looks,
            float[] hierarchy,
            float[] meshes,
            float[] sky,
            int[] skyDimensions,
            float[] shadowDisc,
            float[] pixelSamples,
            int width,
            int rows,
            int search,
            int firstMesh,
            int materials,
            int aspect,
            int output) {
        for (@Parallel int i = 0; i < rows; i++) {
            if (i < rows / 2) {
                pixels[i * width] = -1;
            }
        }
    }
}
