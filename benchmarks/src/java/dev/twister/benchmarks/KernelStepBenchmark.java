package dev.twister.benchmarks;

import dev.twister.kernel.CameraRay;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Illumination;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Shadow;
import dev.twister.kernel.SkyLookup;
import dev.twister.scene.Rendering;
import dev.twister.world.FrameInput;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Each step of the scalar kernel in the paper's scene, in nanoseconds a call, over a table of random rays and points.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@OperationsPerInvocation(KernelStepBenchmark.CALLS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class KernelStepBenchmark {
    static final int CALLS = 4096;
    private static final int SHADOW_SAMPLES = 200;
    private static final float PLANE_HEIGHT = -9.75f;

    private final float[] directionX = new float[CALLS];
    private final float[] directionY = new float[CALLS];
    private final float[] directionZ = new float[CALLS];
    private final float[] path = new float[Layout.PATH_LENGTH];
    private final float[] scratch = new float[Layout.SCRATCH_LENGTH];
    private FrameInput input;

    @Setup(Level.Trial)
    public void fill() {
        input = BenchmarkScene.paper(Rendering.DEFAULT.withShadowSamples(SHADOW_SAMPLES))
                .snapshot();
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < CALLS; i++) {
            double x = random.nextDouble(-0.8, 0.8);
            double y = random.nextDouble(-0.5, 0.3);
            double inverse = 1 / Math.sqrt(x * x + y * y + 1);
            directionX[i] = (float) (x * inverse);
            directionY[i] = (float) (y * inverse);
            directionZ[i] = (float) inverse;
        }
    }

    @Benchmark
    public float viewRay() {
        float sum = 0;
        for (int i = 0; i < CALLS; i++) {
            CameraRay.start(path, i & 1023, i >> 3, input.view().frame());
            sum += path[Layout.DIRECTION];
        }
        return sum;
    }

    @Benchmark
    public int closestHit() {
        System.arraycopy(input.view().frame(), Layout.CAMERA_POSITION, path, Layout.ORIGIN, 3);
        path[Layout.LEAVING] = Layout.NOTHING;
        int sum = 0;
        for (int i = 0; i < CALLS; i++) {
            path[Layout.DIRECTION] = directionX[i];
            path[Layout.DIRECTION + 1] = directionY[i];
            path[Layout.DIRECTION + 2] = directionZ[i];
            sum += Hit.find(
                    path,
                    scratch,
                    input.view().frame(),
                    input.bodies().floats(),
                    input.bodies().looks(),
                    input.bodies().meshes(),
                    0);
        }
        return sum;
    }

    /** Points of the plane in front of all spheres, whose shadows fall elsewhere. */
    @Benchmark
    public float shadowWithoutCandidates() {
        return shadows(-20f);
    }

    /** Points of the plane under the spheres, all with something between them and the light. */
    @Benchmark
    public float shadowWithCandidates() {
        return shadows(0.5f);
    }

    private float shadows(float z) {
        float sum = 0;
        for (int i = 0; i < CALLS; i++) {
            float x = -9f + 18f * i / CALLS;
            float distance = (float) Math.sqrt(x * x + PLANE_HEIGHT * PLANE_HEIGHT + z * z);
            path[Layout.POINT] = x;
            path[Layout.POINT + 1] = PLANE_HEIGHT;
            path[Layout.POINT + 2] = z;
            path[Layout.TO_LIGHT] = -x / distance;
            path[Layout.TO_LIGHT + 1] = -PLANE_HEIGHT / distance;
            path[Layout.TO_LIGHT + 2] = -z / distance;
            path[Layout.LIGHT_DISTANCE] = distance;
            path[Layout.NORMAL_DOT_LIGHT] = 1f;
            sum += Shadow.visible(
                    path,
                    Layout.PLANE,
                    scratch,
                    input.view().frame(),
                    input.bodies().floats(),
                    input.bodies().looks(),
                    input.bodies().meshes(),
                    0);
        }
        return sum;
    }

    @Benchmark
    public float shade() {
        float sum = 0;
        for (int i = 0; i < CALLS; i++) {
            float cosine = Math.abs(directionX[i]);
            sum += Illumination.lit(0.2f, cosine, 1f) + Illumination.specular(48f, cosine, 2f * directionZ[i], 4f, 1f);
        }
        return sum;
    }

    @Benchmark
    public float skyLookup() {
        int width = (int) input.view().frame()[Layout.SKY_WIDTH];
        int height = (int) input.view().frame()[Layout.SKY_HEIGHT];
        float sum = 0;
        for (int i = 0; i < CALLS; i++) {
            float column = SkyLookup.column(directionX[i], directionZ[i], 0f, width);
            float row = SkyLookup.row(directionX[i], directionY[i], directionZ[i], height);
            for (int channel = 0; channel < 3; channel++) {
                sum += SkyLookup.radiance(width, height, column, row, channel, input.images());
            }
        }
        return sum;
    }
}
