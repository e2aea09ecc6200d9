package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.kernel.Layout;
import dev.twister.kernel.PixelKernel;
import dev.twister.world.FrameInput;

/** Calls the kernel on the JVM, row by row. */
final class JvmKernel {
    private JvmKernel() {}

    /** Draws one row of the band; {@code shortcuts} is one of {@link PixelKernel}'s values. */
    static void drawRow(FrameInput input, Frame frame, int row, int shortcuts) {
        float[] scratch = new float[Layout.SCRATCH_LENGTH];
        int output = frame.isLinear() ? PixelKernel.LINEAR : PixelKernel.ARGB;
        int width = input.width();
        for (int column = 0; column < width; column++) {
            PixelKernel.draw(
                    column,
                    row,
                    frame.argb(),
                    frame.radiance(),
                    input.dimensions(),
                    input.camera(),
                    input.rayTracingProperties(),
                    input.bodyPositions(),
                    input.bodySizes(),
                    input.bodyColors(),
                    input.bodyReflectivities(),
                    input.skybox(),
                    input.skyboxDimensions(),
                    input.shadowDisc(),
                    input.pixelOffsets(),
                    input.hierarchy(),
                    scratch,
                    shortcuts,
                    output);
        }
    }
}
