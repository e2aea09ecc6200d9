package dev.twister.engine.tornado;

import dev.twister.kernel.Aspect;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Material;
import dev.twister.kernel.PixelKernel;
import java.util.function.Supplier;
import uk.ac.manchester.tornado.api.annotations.Parallel;

/** The code that TornadoVM compiles; public for {@link DeviceClassLoader}. */
public final class TornadoKernel implements Supplier<DrawTask> {
    /** Scratch length for few plain spheres, which fit one leaf, so no node waits. */
    static final int FEW_SCRATCH = Layout.CANDIDATE_STRIDE * 32;

    /** Index of the first mesh's body in {@code dimensions}, after the values of {@link Layout}. */
    static final int FIRST_MESH = Layout.DIMENSIONS_LENGTH;

    static final int DIMENSIONS_LENGTH = FIRST_MESH + 1;

    @Override
    public DrawTask get() {
        return TornadoKernel::draw;
    }

    /**
     * Renders all pixels of a band, one work-item per pixel. Scalars are compiled in as constants. Data that changes
     * between frames is in the arrays, which are those of {@link dev.twister.world.FrameInput}.
     *
     * @param pixels {@code int[width * rows]} if the output is ARGB, else one int
     * @param radiance {@code float[3 * width * rows]} if the output is LINEAR, else one float
     * @param dimensions {@value #DIMENSIONS_LENGTH} ints, with the first mesh's body at {@link #FIRST_MESH}
     * @param search a constant of {@link dev.twister.kernel.Hit}
     * @param firstMesh {@link Layout#NO_MESHES} if there are none, else any other value
     * @param materials a constant of {@link Material}
     * @param aspect a constant of {@link Aspect}
     * @param output a constant of {@link PixelKernel}
     */
    static void draw(
            int[] pixels,
            float[] radiance,
            int[] dimensions,
            float[] camera,
            float[] properties,
            float[] places,
            float[] looks,
            float[] hierarchy,
            float[] meshes,
            float[] sky,
            int[] skyDimensions,
            float[] shadowDisc,
            float[] pixelSamples,
            int width,
            int rows,
            int search,
            int firstMesh,
            int materials,
            int aspect,
            int output) {
        for (@Parallel int row = 0; row < rows; row++) {
            for (@Parallel int column = 0; column < width; column++) {
                int isPlain = (materials == Material.PLAIN ? 1 : 0) & (firstMesh == Layout.NO_MESHES ? 1 : 0);
                int plainPath = Aspect.isCount(aspect) == 0 ? Layout.PLAIN_PATH_LENGTH : Layout.PATH_LENGTH;
                float[] path = new float[isPlain != 0 ? plainPath : Layout.PATH_LENGTH];
                int plainScratch = search == Hit.ALL ? FEW_SCRATCH : Layout.PLAIN_SCRATCH_LENGTH;
                float[] scratch = new float[isPlain != 0 ? plainScratch : Layout.SCRATCH_LENGTH];
                // As a constant, the number would make conditions constant, which the OpenCL backend cannot compile.
                int mesh = firstMesh == Layout.NO_MESHES ? Layout.NO_MESHES : dimensions[FIRST_MESH];
                PixelKernel.draw(
                        column,
                        row,
                        pixels,
                        radiance,
                        dimensions,
                        camera,
                        properties,
                        places,
                        looks,
                        hierarchy,
                        meshes,
                        sky,
                        skyDimensions,
                        shadowDisc,
                        pixelSamples,
                        path,
                        scratch,
                        search,
                        mesh,
                        materials,
                        aspect,
                        output);
            }
        }
    }
}
