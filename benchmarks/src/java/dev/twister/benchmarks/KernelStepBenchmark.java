package dev.twister.benchmarks;

import dev.twister.kernel.ClosestHit;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Shading;
import dev.twister.kernel.SkyLookup;
import dev.twister.kernel.SoftShadow;
import dev.twister.kernel.ViewRay;
import dev.twister.scene.RenderSettings;
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

/** Each step of the scalar kernel in the paper's scene, in nanoseconds a call, over a table of random rays and points. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@OperationsPerInvocation(KernelStepBenchmark.CALLS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class KernelStepBenchmark {
    static final int CALLS = 4096;
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    private static final int SHADOW_SAMPLES = 200;
    private static final float PLANE_HEIGHT = -9.75f;
    private static final float LIGHT_DISC_RADIUS = 2.4f;

    private final float[] directionX = new float[CALLS];
    private final float[] directionY = new float[CALLS];
    private final float[] directionZ = new float[CALLS];
    private final float[] scratch = new float[Layout.SCRATCH_LENGTH];
    private FrameInput input;

    @Setup(Level.Trial)
    public void fill() {
        input = BenchmarkScene.paper(RenderSettings.DEFAULT.withShadows(SHADOW_SAMPLES))
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
            sum += ViewRay.u(i, WIDTH, HEIGHT) * ViewRay.v(i >> 3, WIDTH, HEIGHT);
        }
        return sum;
    }

    @Benchmark
    public int closestHit() {
        int sum = 0;
        for (int i = 0; i < CALLS; i++) {
            sum += ClosestHit.body(
                    input.camera()[0],
                    input.camera()[1],
                    input.camera()[2],
                    directionX[i],
                    directionY[i],
                    directionZ[i],
                    Layout.NOTHING,
                    input.bodyPositions(),
                    input.bodySizes(),
                    input.bodies());
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
            sum += SoftShadow.visible(
                    x,
                    PLANE_HEIGHT,
                    z,
                    Layout.PLANE,
                    -x / distance,
                    -PLANE_HEIGHT / distance,
                    -z / distance,
                    distance,
                    LIGHT_DISC_RADIUS,
                    SHADOW_SAMPLES,
                    input.shadowDisc(),
                    input.hierarchy(),
                    Layout.root(input.bodies()),
                    scratch);
        }
        return sum;
    }

    @Benchmark
    public float shade() {
        float sum = 0;
        for (int i = 0; i < CALLS; i++) {
            float cosine = Math.abs(directionX[i]);
            sum += Shading.lit(0.2f, cosine, 1f) + Shading.specular(48f, cosine, 2f * directionZ[i], 4f, 1f);
        }
        return sum;
    }

    @Benchmark
    public float skyLookup() {
        int width = input.skyboxDimensions()[Layout.SKYBOX_WIDTH];
        int height = input.skyboxDimensions()[Layout.SKYBOX_HEIGHT];
        float sum = 0;
        for (int i = 0; i < CALLS; i++) {
            float column = SkyLookup.column(directionX[i], directionZ[i], width);
            float row = SkyLookup.row(directionX[i], directionY[i], directionZ[i], height);
            for (int channel = 0; channel < 3; channel++) {
                sum += SkyLookup.radiance(input.skybox(), width, height, column, row, channel);
            }
        }
        return sum;
    }
}
