package dev.twister.engine.tornado;

import dev.twister.kernel.Aspect;
import dev.twister.kernel.Layout;
import dev.twister.kernel.PixelKernel;
import dev.twister.kernel.Variant;
import java.util.function.Supplier;
import uk.ac.manchester.tornado.api.annotations.Parallel;

/** The code that TornadoVM compiles; public for {@link DeviceClassLoader}. */
public final class TornadoKernel implements Supplier<DrawTask> {
    /** Scratch length for few plain spheres, which fit one leaf, so no node waits. */
    static final int FEW_SCRATCH = Layout.CANDIDATE_STRIDE * 32;

    @Override
    public DrawTask get() {
        return TornadoKernel::draw;
    }

    /**
     * Renders all pixels of a band, one work-item per pixel. Scalars are compiled in as constants. Data that changes
     * between frames is in the arrays, which are those of {@link dev.twister.world.FrameInput}.
     *
     * @param pixels {@code int[width * rows]} if the output is ARGB, else one int
     * @param radiance {@code float[3 * width * rows]} if the output is linear, and as many for each further layer; else
     *     one float
     * @param variant bits of {@link Variant}
     */
    static void draw(
            int[] pixels,
            float[] radiance,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int width,
            int rows,
            int variant) {
        for (@Parallel int row = 0; row < rows; row++) {
            for (@Parallel int column = 0; column < width; column++) {
                int isPlain = (variant & (Variant.MATERIALS | Variant.MESHES)) == 0 ? 1 : 0;
                int isShort = Aspect.isCount(variant) == 0 ? (variant & Variant.LIGHTS) == 0 ? 1 : 0 : 0;
                int plainPath = isShort != 0 ? Layout.PLAIN_PATH_LENGTH : Layout.PATH_LENGTH;
                int longPath = (variant & Variant.PATH) != 0 ? Layout.TRACED_PATH_LENGTH : Layout.PATH_LENGTH;
                int usualPath = isPlain != 0 ? plainPath : longPath;
                int layered = Aspect.isLayered(variant);
                int guidedPath = layered != 0 ? Layout.LAYERED_PATH_LENGTH : Layout.GUIDED_PATH_LENGTH;
                float[] path = new float[Aspect.isGuided(variant) != 0 ? guidedPath : usualPath];
                int plainScratch = (variant & Variant.WALK) == 0 ? FEW_SCRATCH : Layout.PLAIN_SCRATCH_LENGTH;
                int usualScratch = isPlain != 0 ? plainScratch : Layout.SCRATCH_LENGTH;
                float[] scratch = new float[layered != 0 ? Layout.LAYERED_SCRATCH_LENGTH : usualScratch];
                PixelKernel.draw(column, row, path, scratch, frame, bodies, looks, meshes, images, variant);
                PixelKernel.store(
                        column, row, pixels, radiance, radiance, 3 * width * rows, path, scratch, frame, variant);
            }
        }
    }
}
