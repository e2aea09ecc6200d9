package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.kernel.PixelKernel;
import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;

/** The plain reference: the kernel's equations without any shortcut, on one thread. */
public final class PlainPicture {
    private PlainPicture() {}

    /** The pixels as 0xAARRGGBB. */
    public static int[] argb(Scene scene, Skybox sky) {
        FrameInput input = World.of(scene, sky).snapshot();
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        for (int row = 0; row < frame.height(); row++) {
            JvmKernel.drawRow(input, frame, row, PixelKernel.PLAIN);
        }
        return frame.argb();
    }
}
