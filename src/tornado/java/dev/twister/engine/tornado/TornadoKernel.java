package dev.twister.engine.tornado;

import dev.twister.kernel.Layout;
import dev.twister.kernel.PixelKernel;
import dev.twister.kernel.Variant;
import dev.twister.kernel.Views;
import dev.twister.scene.Rendering;
import dev.twister.world.hierarchy.SphereHierarchy;
import java.util.function.Supplier;
import uk.ac.manchester.tornado.api.annotations.Parallel;
import uk.ac.manchester.tornado.api.types.arrays.FloatArray;
import uk.ac.manchester.tornado.api.types.arrays.IntArray;

/** The code that TornadoVM compiles; public for {@link DeviceClassLoader}. */
public final class TornadoKernel implements Supplier<DrawTask> {
    /** More samples per pixel are rendered in several passes. */
    static final int MOST_SAMPLES = 1024;

    static final int FEW_SCRATCH = Layout.CANDIDATE_STRIDE * SphereHierarchy.FEWEST_SPHERES;

    /** Place in {@code frame}, behind all else, of the number of the first pixel in {@code pixels}. */
    static final int FIRST_PIXEL =
            Layout.DISC + 2 * Rendering.MAX_SHADOW_SAMPLES + Layout.SAMPLE_STRIDE * MOST_SAMPLES + Layout.MOST_TILES;

    @Override
    public DrawTask get() {
        return TornadoKernel::draw;
    }

    /**
     * Renders all pixels of a band, one work-item per pixel. The variant is compiled in as a constant. All else is in
     * the arrays, which are those of {@link dev.twister.world.FrameInput}, so that other sizes and numbers of bodies
     * need no other code.
     *
     * @param pixels at least {@code width * rows} ints from {@link #FIRST_PIXEL} on if the output is ARGB, else one
     * @param radiance at least {@code 3 * width * rows} floats if the output is linear, else one
     * @param layers at least {@code 3 * width * rows} floats for each further layer
     * @param variant bits of {@link Variant}
     */
    static void draw(
            IntArray pixels,
            FloatArray radiance,
            float[] layers,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int width = (int) frame[Layout.WIDTH];
        int rows = (int) frame[Layout.ROWS];
        for (@Parallel int row = 0; row < rows; row++) {
            for (@Parallel int column = 0; column < width; column++) {
                int isPlain = (variant & (Variant.MATERIALS | Variant.MESHES)) == 0 ? 1 : 0;
                int isShort = Views.isCount(variant) == 0 ? (variant & Variant.LIGHTS) == 0 ? 1 : 0 : 0;
                int plainPath = isShort != 0 ? Layout.PLAIN_PATH_LENGTH : Layout.PATH_LENGTH;
                int longPath = (variant & Variant.PATH) != 0 ? Layout.TRACED_PATH_LENGTH : Layout.PATH_LENGTH;
                int usualPath = isPlain != 0 ? plainPath : longPath;
                int layered = Views.isLayered(variant);
                int guidedPath = layered != 0 ? Layout.LAYERED_PATH_LENGTH : Layout.GUIDED_PATH_LENGTH;
                int shortPath = Views.isCut(variant) != 0 ? Layout.CUT_PATH_LENGTH : usualPath;
                int barePath = Views.isGuided(variant) != 0 ? guidedPath : shortPath;
                float[] path = new float[(variant & Variant.FINISH) != 0 ? Layout.FINISHED_PATH_LENGTH : barePath];
                float[] scratch = new float[scratchLength(variant)];
                PixelKernel.draw(column, row, path, scratch, frame, bodies, looks, meshes, images, variant);
                int pixel = row * width + column;
                if ((variant & Variant.LINEAR) != 0) {
                    float average = PixelKernel.average(frame);
                    radiance.set(3 * pixel, path[Layout.RADIANCE] * average);
                    radiance.set(3 * pixel + 1, path[Layout.RADIANCE + 1] * average);
                    radiance.set(3 * pixel + 2, path[Layout.RADIANCE + 2] * average);
                    PixelKernel.storeLayers(pixel, layers, path, scratch, frame, variant);
                } else {
                    pixels.set((int) frame[FIRST_PIXEL] + pixel, PixelKernel.argb(path, frame));
                }
            }
        }
    }

    /** Floats of scratch that a variant needs. */
    private static int scratchLength(int variant) {
        int hasMeshes = variant & Variant.MESHES;
        int isTraced = (variant & Variant.PATH) != 0 ? 1 - Views.endsAtFirstHit(variant) : 0;
        // Traced paths have no stored candidates and no waiting rays.
        int traced = hasMeshes != 0 ? Layout.SCRATCH_RAY_NODES + 2 * Layout.MOST_ANCESTORS : Layout.SCRATCH_RAY_NODES;
        // Few spheres have no hierarchy, and are all candidates at most.
        int spheres = (variant & Variant.WALK) != 0 ? Layout.SCRATCH_SHADOW_NODES : FEW_SCRATCH;
        int plain = hasMeshes != 0 ? Layout.SCRATCH_TRANSMISSIONS : spheres;
        int shaded = (variant & Variant.MATERIALS) != 0 ? Layout.SCRATCH_LENGTH : plain;
        int usual = isTraced != 0 ? traced : shaded;
        return Views.isLayered(variant) != 0 ? Layout.LAYERED_SCRATCH_LENGTH : usual;
    }
}
