package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.kernel.Aspect;
import dev.twister.kernel.Camera;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Light;
import dev.twister.kernel.Material;
import dev.twister.kernel.PlainShadow;
import dev.twister.kernel.Scatter;
import dev.twister.kernel.Sky;
import dev.twister.kernel.Surface;
import dev.twister.kernel.Tone;
import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;

/** The brute-force reference: the kernel's equations without any shortcut, on one thread. */
public final class PlainPicture {
    private final FrameInput input;
    private final float[] properties;
    private final float[] path = new float[Layout.PATH_LENGTH];

    private PlainPicture(FrameInput input) {
        this.input = input;
        properties = input.view().properties();
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
        float[] offsets = input.view().pixelSamples();
        for (int sample = 0; sample < input.samplesPerPixel(); sample++) {
            Camera.start(
                    path,
                    column + offsets[Layout.SAMPLE_STRIDE * sample],
                    row + offsets[Layout.SAMPLE_STRIDE * sample + 1],
                    input.view().dimensions(),
                    input.view().camera());
            follow();
        }
        return Tone.argb(path, 1f / input.samplesPerPixel(), properties);
    }

    private void follow() {
        float[] places = input.bodies().places();
        float[] looks = input.bodies().looks();
        boolean goesOn = true;
        for (int bounce = 0; bounce <= input.bounces() && goesOn; bounce++) {
            int body = Hit.find(
                    path,
                    places,
                    looks,
                    input.bodies().hierarchy(),
                    input.bodies().meshes(),
                    input.bodyCount(),
                    new float[0],
                    Hit.ALL,
                    Layout.NO_MESHES,
                    Material.PLAIN,
                    Aspect.FULL);
            goesOn = body >= Layout.PLANE;
            if (body == Layout.NOTHING) {
                Sky.add(path, input.panorama().texels(), input.panorama().dimensions(), properties);
            } else if (body == Layout.LIGHT) {
                Light.add(path, looks);
            } else {
                Surface.find(
                        path,
                        body,
                        places,
                        input.bodies().hierarchy(),
                        input.bodies().meshes(),
                        Layout.NO_MESHES);
                Material.find(
                        path,
                        body,
                        looks,
                        properties,
                        input.panorama().texels(),
                        input.panorama().dimensions(),
                        Layout.NO_MESHES,
                        Material.PLAIN);
                Light.aim(path, places);
                float visible = PlainShadow.visible(path, body, input.shadowSamples(), places, input.bodyCount());
                float mirror = bounce == input.bounces() ? 0 : path[Layout.REFLECTIVITY] / Layout.MAX_REFLECTIVITY;
                float lit = Light.lit(properties[Layout.AMBIENT], path[Layout.NORMAL_DOT_LIGHT], visible);
                Scatter.shade(path, visible, mirror, 0, lit, looks);
                Scatter.reflect(path, body, mirror * lit);
                goesOn = path[Layout.THROUGHPUT] > 0;
            }
        }
    }
}
