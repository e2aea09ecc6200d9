package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Illumination;
import dev.twister.kernel.Layout;
import dev.twister.kernel.PixelKernel;
import dev.twister.kernel.PlainShadow;
import dev.twister.kernel.Scatter;
import dev.twister.kernel.SkyLookup;
import dev.twister.kernel.Surface;
import dev.twister.kernel.SurfaceLook;
import dev.twister.kernel.Tone;
import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;

/** The brute-force reference: the kernel's equations without any shortcut, on one thread. */
public final class PlainPicture {
    private final FrameInput input;
    private final float[] path = new float[Layout.PATH_LENGTH];

    private PlainPicture(FrameInput input) {
        this.input = input;
    }

    /** Returns the pixels as 0xAARRGGBB. */
    public static int[] argb(Scene scene, Skybox sky) {
        FrameInput input = World.of(scene, sky).snapshot();
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        PlainPicture picture = new PlainPicture(input);
        for (int pixel = 0; pixel < frame.argb().length; pixel++) {
            frame.argb()[pixel] = picture.argb(pixel % input.width(), pixel / input.width());
        }
        return frame.argb();
    }

    private int argb(int column, int row) {
        path[Layout.RADIANCE] = 0;
        path[Layout.RADIANCE + 1] = 0;
        path[Layout.RADIANCE + 2] = 0;
        for (int sample = 0; sample < input.samplesPerPixel(); sample++) {
            PixelKernel.start(path, column, row, sample, input.view().frame());
            follow();
        }
        return Tone.argb(path, 1f / input.samplesPerPixel(), input.view().frame());
    }

    private void follow() {
        float[] frame = input.view().frame();
        float[] bodies = input.bodies().floats();
        float[] looks = input.bodies().looks();
        float[] none = new float[0];
        boolean goesOn = true;
        for (int bounce = 0; bounce <= input.bounces() && goesOn; bounce++) {
            int body = Hit.find(path, none, frame, bodies, looks, none, 0);
            goesOn = body >= Layout.PLANE;
            if (body == Layout.NOTHING) {
                SkyLookup.add(path, frame, input.images());
            } else if (body == Layout.LIGHT) {
                Illumination.add(path, body, looks);
            } else {
                Surface.find(path, body, frame, bodies, none, 0);
                SurfaceLook.find(path, body, frame, looks, none, 0);
                Illumination.aim(path, Layout.LIGHT, bodies);
                float visible = PlainShadow.visible(path, body, input.shadowSamples(), bodies, input.bodyCount());
                float mirror = bounce == input.bounces() ? 0 : path[Layout.REFLECTIVITY] / Layout.MAX_REFLECTIVITY;
                float lit = Illumination.lit(frame[Layout.AMBIENT], path[Layout.NORMAL_DOT_LIGHT], visible);
                Scatter.shade(path, visible, mirror, 0, lit, looks, 0);
                Scatter.reflect(path, body, mirror * lit);
                goesOn = path[Layout.THROUGHPUT] > 0;
            }
        }
    }
}
