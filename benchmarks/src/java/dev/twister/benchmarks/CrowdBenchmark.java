package dev.twister.benchmarks;

import dev.twister.kernel.Layout;
import dev.twister.kernel.NearestHit;
import dev.twister.kernel.SoftShadow;
import dev.twister.scene.RenderSettings;
import dev.twister.world.FrameInput;
import dev.twister.world.SphereHierarchy;
import dev.twister.world.World;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The hierarchy over a crowd of spheres: building it, in milliseconds, and walking it, in nanoseconds a ray or point. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class CrowdBenchmark {
    private static final int SIDE = 64;
    private static final int CALLS = SIDE * SIDE;
    private static final int SHADOW_SAMPLES = 16;
    private static final float LIGHT_DISC_RADIUS = 2f;

    @Param({"100", "1000", "10000", "100000"})
    int spheres;

    private final float[] scratch = new float[Layout.SCRATCH_LENGTH];
    private World world;
    private FrameInput input;

    /** What the lowest and the highest centre leave between them, along x, y and z. */
    private final float[] low = new float[3];

    private final float[] high = new float[3];

    @Setup(Level.Trial)
    public void fill() {
        world = BenchmarkScene.withSpheres(spheres, RenderSettings.DEFAULT.withShadows(SHADOW_SAMPLES));
        input = world.snapshot();
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Float.MAX_VALUE;
            high[axis] = -Float.MAX_VALUE;
            for (int body = Layout.FIRST_SPHERE; body < input.bodies(); body++) {
                low[axis] = Math.min(low[axis], input.bodyPositions()[3 * body + axis]);
                high[axis] = Math.max(high[axis], input.bodyPositions()[3 * body + axis]);
            }
        }
    }

    @Benchmark
    @OutputTimeUnit(TimeUnit.MILLISECONDS)
    public float[] build() {
        return SphereHierarchy.of(input.bodyPositions(), input.bodySizes(), input.bodies());
    }

    /** Rays into the crowd from above it, slanting. */
    @Benchmark
    @OutputTimeUnit(TimeUnit.NANOSECONDS)
    @OperationsPerInvocation(CALLS)
    public int closestHit() {
        float slope = (float) Math.sqrt(0.5);
        int sum = 0;
        for (int i = 0; i < CALLS; i++) {
            sum += NearestHit.body(
                    x(i),
                    2 * high[1] - low[1],
                    z(i),
                    slope,
                    -slope,
                    0f,
                    Layout.NOTHING,
                    input.bodyPositions(),
                    input.bodySizes(),
                    input.hierarchy(),
                    Layout.root(input.bodies()),
                    scratch);
        }
        return sum;
    }

    /** Points of a level through the crowd's middle, under a light straight above. */
    @Benchmark
    @OutputTimeUnit(TimeUnit.NANOSECONDS)
    @OperationsPerInvocation(CALLS)
    public float shadow() {
        float sum = 0;
        for (int i = 0; i < CALLS; i++) {
            sum += SoftShadow.visible(
                    x(i),
                    0.5f * (low[1] + high[1]),
                    z(i),
                    Layout.PLANE,
                    0f,
                    1f,
                    0f,
                    2f * (high[1] - low[1]) + 10f * LIGHT_DISC_RADIUS,
                    LIGHT_DISC_RADIUS,
                    SHADOW_SAMPLES,
                    input.shadowDisc(),
                    input.hierarchy(),
                    Layout.root(input.bodies()),
                    scratch);
        }
        return sum;
    }

    private float x(int call) {
        return low[0] + (high[0] - low[0]) * (call % SIDE + 0.5f) / SIDE;
    }

    private float z(int call) {
        return low[2] + (high[2] - low[2]) * ((float) (call / SIDE) + 0.5f) / SIDE;
    }
}
