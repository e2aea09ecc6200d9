package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.kernel.Layout;
import dev.twister.kernel.PixelKernel;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import dev.twister.world.Panorama;
import dev.twister.world.View;

/** Calls the kernel on the JVM, row by row. */
final class JvmKernel {
    private JvmKernel() {}

    /** Draws one row of the band. */
    static void drawRow(FrameInput input, Frame frame, int row) {
        float[] path = new float[Layout.PATH_LENGTH];
        float[] scratch = new float[Layout.SCRATCH_LENGTH];
        int search = HitSearch.of(input);
        int output = frame.isLinear() ? PixelKernel.LINEAR : PixelKernel.ARGB;
        View view = input.view();
        Bodies bodies = input.bodies();
        Panorama panorama = input.panorama();
        int width = input.width();
        for (int column = 0; column < width; column++) {
            PixelKernel.draw(
                    column,
                    row,
                    frame.argb(),
                    frame.radiance(),
                    view.dimensions(),
                    view.camera(),
                    view.properties(),
                    bodies.places(),
                    bodies.looks(),
                    bodies.hierarchy(),
                    panorama.texels(),
                    panorama.dimensions(),
                    view.shadowDisc(),
                    view.pixelOffsets(),
                    path,
                    scratch,
                    search,
                    output);
        }
    }
}
