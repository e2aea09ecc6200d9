package dev.twister.engine.tornado;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Strip;
import dev.twister.kernel.StripKernel;
import java.util.function.Supplier;
import uk.ac.manchester.tornado.api.annotations.Parallel;

/** What TornadoVM compiles for devices that are CPUs; public for {@link DeviceClassLoader}. */
public final class TornadoStripKernel implements Supplier<DrawTask> {
    @Override
    public DrawTask get() {
        return TornadoStripKernel::draw;
    }

    /** All pixels of a band, one work-item a strip of them, row by row; the arguments are {@link TornadoKernel#draw}'s. */
    static void draw(
            int[] pixels,
            float[] radiance,
            int[] dimensions,
            float[] camera,
            float[] rayTracingProperties,
            float[] bodyPositions,
            float[] bodySizes,
            float[] bodyColors,
            float[] bodyReflectivities,
            float[] skybox,
            int[] skyboxDimensions,
            float[] shadowDisc,
            float[] pixelOffsets,
            float[] hierarchy,
            int width,
            int rows,
            int shortcuts,
            int output) {
        int stripsInRow = Strip.inRow(width);
        // A product, as TornadoVM prints a warning where a scalar by itself ends a loop that has a grid.
        int strips = rows * stripsInRow;
        for (@Parallel int strip = 0; strip < strips; strip++) {
            float[] lanes = new float[Strip.FLOATS];
            int[] marks = new int[Strip.MARKS];
            float[] scratch = new float[Layout.SCRATCH_LENGTH];
            int row = strip / stripsInRow;
            StripKernel.draw(
                    (strip - row * stripsInRow) * Strip.LANES,
                    row,
                    pixels,
                    radiance,
                    dimensions,
                    camera,
                    rayTracingProperties,
                    bodyPositions,
                    bodySizes,
                    bodyColors,
                    bodyReflectivities,
                    skybox,
                    skyboxDimensions,
                    shadowDisc,
                    pixelOffsets,
                    hierarchy,
                    lanes,
                    marks,
                    scratch,
                    shortcuts,
                    output);
        }
    }
}
