package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.kernel.Aspect;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Path;
import dev.twister.kernel.PixelKernel;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import dev.twister.world.Panorama;
import dev.twister.world.View;

/** Calls the kernel on the JVM. Each thread needs its own instance. */
public final class JvmKernel {
    private final float[] path = new float[Layout.PATH_LENGTH];
    private final float[] scratch = new float[Layout.SCRATCH_LENGTH];

    /** The path for {@link #follow} and {@link #visible}: {@link Layout#PATH_LENGTH} floats. */
    public float[] path() {
        return path;
    }

    /** Renders the pixels of one row of the band, from {@code firstColumn} to before {@code endColumn}. */
    public void drawRow(FrameInput input, Frame frame, int row, int firstColumn, int endColumn) {
        int search = HitSearch.of(input);
        int materials = input.bodies().materials();
        int aspect = input.aspect();
        int output = frame.isLinear() ? PixelKernel.LINEAR : PixelKernel.ARGB;
        View view = input.view();
        Bodies bodies = input.bodies();
        Panorama panorama = input.panorama();
        for (int column = firstColumn; column < endColumn; column++) {
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
                    bodies.meshes(),
                    panorama.texels(),
                    panorama.dimensions(),
                    view.shadowDisc(),
                    view.pixelSamples(),
                    path,
                    scratch,
                    search,
                    bodies.firstMesh(),
                    materials,
                    aspect,
                    output);
        }
    }

    /**
     * The visible part of the light, in [0, 1], where the {@link #path} hits a body: {@link Path#visible}.
     *
     * @param bounce number of surfaces that the path has left
     */
    public float visible(FrameInput input, int body, int bounce) {
        View view = input.view();
        Bodies bodies = input.bodies();
        Panorama panorama = input.panorama();
        Path.meet(
                path,
                body,
                view.properties(),
                bodies.places(),
                bodies.looks(),
                bodies.hierarchy(),
                bodies.meshes(),
                panorama.texels(),
                panorama.dimensions(),
                bodies.firstMesh(),
                bodies.materials());
        return Path.visible(
                path,
                body,
                bounce,
                view.properties(),
                bodies.places(),
                bodies.looks(),
                bodies.hierarchy(),
                bodies.meshes(),
                input.bodyCount(),
                view.shadowDisc(),
                scratch,
                bodies.firstMesh(),
                bodies.materials(),
                Aspect.FULL);
    }

    /** Follows the {@link #path} from a bounce on: {@link Path#follow}. */
    public void follow(FrameInput input, int bounce) {
        Path.follow(
                path,
                bounce,
                input.view().properties(),
                input.bodies().places(),
                input.bodies().looks(),
                input.bodies().hierarchy(),
                input.bodies().meshes(),
                input.bodyCount(),
                input.panorama().texels(),
                input.panorama().dimensions(),
                input.view().shadowDisc(),
                input.view().pixelSamples(),
                scratch,
                HitSearch.of(input),
                input.bodies().firstMesh(),
                input.bodies().materials(),
                Aspect.FULL);
    }
}
