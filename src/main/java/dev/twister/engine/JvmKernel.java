package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Path;
import dev.twister.kernel.PixelKernel;
import dev.twister.kernel.SeveralLights;
import dev.twister.kernel.Variant;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import dev.twister.world.View;

/** Calls the kernel on the JVM. Each thread needs its own instance. */
public final class JvmKernel {
    private final float[] path = new float[Layout.FINISHED_PATH_LENGTH];
    private final float[] scratch = new float[Layout.LAYERED_SCRATCH_LENGTH];

    /** The path for {@link #follow} and {@link #visible}: {@link Layout#PATH_LENGTH} floats. */
    public float[] path() {
        return path;
    }

    /**
     * Renders the pixels of one row of the band, from {@code firstColumn} to before {@code endColumn}, or until the
     * frame is stopped.
     */
    public void drawRow(FrameInput input, FrameStop stop, int row, int firstColumn, int endColumn) {
        Frame frame = stop.frame();
        View view = input.view();
        Bodies bodies = input.bodies();
        int variant = input.variant(frame.isLinear());
        int[] argb = frame.argb();
        for (int column = firstColumn; column < endColumn && !stop.isAsked(); column++) {
            PixelKernel.draw(
                    column,
                    row,
                    path,
                    scratch,
                    view.frame(),
                    bodies.floats(),
                    bodies.looks(),
                    bodies.meshes(),
                    input.images(),
                    variant);
            PixelKernel.store(
                    column, row, argb, frame.radiance(), frame.layers(), path, scratch, view.frame(), variant);
        }
    }

    /**
     * The visible part of a light, in [0, 1], where the {@link #path} hits a body: {@link Path#visible}.
     *
     * @param bounce number of surfaces that the path has left
     * @param light the light's body
     */
    public float visible(FrameInput input, int body, int bounce, int light) {
        float[] frame = input.view().frame();
        Bodies bodies = input.bodies();
        int variant = input.variant(false);
        path[Layout.BOUNCE] = bounce;
        Path.meet(path, body, frame, bodies.floats(), bodies.looks(), bodies.meshes(), input.images(), variant);
        if ((variant & Variant.LIGHTS) != 0) {
            SeveralLights.choose(path, light, bodies.floats(), bodies.looks());
        }
        return Path.visible(path, body, scratch, frame, bodies.floats(), bodies.looks(), bodies.meshes(), variant);
    }

    /** The closest body that the {@link #path}'s ray meets: {@link Hit#find}. */
    public int hit(FrameInput input) {
        Bodies bodies = input.bodies();
        return Hit.find(
                path,
                scratch,
                input.view().frame(),
                bodies.floats(),
                bodies.looks(),
                bodies.meshes(),
                input.variant(false));
    }

    /** Follows the {@link #path} from a bounce on: {@link Path#follow}. */
    public void follow(FrameInput input, int bounce) {
        path[Layout.BOUNCE] = bounce;
        path[Layout.WAITING] = 0;
        // Lanes have no rays in bodies that take light.
        path[Layout.MEDIUM] = Layout.NOTHING;
        path[Layout.OUTER_MEDIUM] = Layout.NOTHING;
        Path.follow(
                path,
                scratch,
                input.view().frame(),
                input.bodies().floats(),
                input.bodies().looks(),
                input.bodies().meshes(),
                input.images(),
                input.variant(false));
    }
}
