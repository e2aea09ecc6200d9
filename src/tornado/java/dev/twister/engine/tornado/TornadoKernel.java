package dev.twister.engine.tornado;

import dev.twister.kernel.Aspect;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Material;
import dev.twister.kernel.PixelKernel;
import java.util.function.Supplier;
import uk.ac.manchester.tornado.api.annotations.Parallel;

/** What TornadoVM compiles; public for {@link DeviceClassLoader}. */
public final class TornadoKernel implements Supplier<DrawTask> {
    /** Few plain spheres are fewer, and one leaf: all are remembered, and no node waits. */
    static final int FEW_SCRATCH = Layout.CANDIDATE_STRIDE * 32;

    /** Where {@code dimensions} has the first mesh's body, after what {@link Layout} puts there. */
    static final int FIRST_MESH = Layout.DIMENSIONS_LENGTH;

    static final int DIMENSIONS_LENGTH = FIRST_MESH + 1;

    @Override
    public DrawTask get() {
        return TornadoKernel::draw;
    }

    /**
     * All pixels of a band, one work-item each. The scalars are compiled in as constants; whatever changes from frame
     * to frame is in the arrays, which are {@link dev.twister.world.FrameInput}'s.
     *
     * @param pixels {@code int[width * rows]} where the output is ARGB, else one int
     * @param radiance {@code float[3 * width * rows]} where the output is LINEAR, else one float
     * @param dimensions {@value #DIMENSIONS_LENGTH} numbers, the first mesh's body at {@link #FIRST_MESH}
     * @param search one of {@link dev.twister.kernel.Hit}'s
     * @param firstMesh {@link Layout#NO_MESHES} where there are none, else any other
     * @param materials one of {@link Material}'s
     * @param aspect one of {@link Aspect}'s
     * @param output one of {@link PixelKernel}'s
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
                // Compiled in, the number would make conditions constant, which the OpenCL backend does not compile.
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
