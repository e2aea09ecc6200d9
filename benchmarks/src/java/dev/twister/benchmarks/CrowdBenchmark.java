package dev.twister.benchmarks;

import dev.twister.kernel.Hit;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Shadow;
import dev.twister.kernel.Variant;
import dev.twister.scene.Rendering;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import dev.twister.world.hierarchy.SphereHierarchy;
import java.util.Arrays;
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

/**
 * The hierarchy over a crowd of spheres: building it, in milliseconds, and walking it, in nanoseconds a ray or point.
 */
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

    private final float[] path = new float[Layout.PATH_LENGTH];
    private final float[] scratch = new float[Layout.SCRATCH_LENGTH];
    private World world;
    private FrameInput input;
    private float[] places;

    /** What the lowest and the highest center leave between them, along x, y and z. */
    private final float[] low = new float[3];

    private final float[] high = new float[3];

    @Setup(Level.Trial)
    public void fill() {
        world = BenchmarkScene.withSpheres(spheres, Rendering.DEFAULT.withShadowSamples(SHADOW_SAMPLES));
        input = world.snapshot();
        places = Arrays.copyOf(input.bodies().floats(), input.bodies().spheres());
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Float.MAX_VALUE;
            high[axis] = -Float.MAX_VALUE;
            for (int body = Layout.FIRST_SPHERE; body < input.bodyCount(); body++) {
                low[axis] = Math.min(low[axis], input.bodies().center(body, axis));
                high[axis] = Math.max(high[axis], input.bodies().center(body, axis));
            }
        }
    }

    @Benchmark
    @OutputTimeUnit(TimeUnit.MILLISECONDS)
    public float[] build() {
        return SphereHierarchy.of(places, input.bodyCount());
    }

    /** Rays into the crowd from above it, slanting. */
    @Benchmark
    @OutputTimeUnit(TimeUnit.NANOSECONDS)
    @OperationsPerInvocation(CALLS)
    public int closestHit() {
        float slope = (float) Math.sqrt(0.5);
        path[Layout.LEAVING] = Layout.NOTHING;
        path[Layout.DIRECTION] = slope;
        path[Layout.DIRECTION + 1] = -slope;
        path[Layout.DIRECTION + 2] = 0f;
        int sum = 0;
        for (int i = 0; i < CALLS; i++) {
            path[Layout.ORIGIN] = x(i);
            path[Layout.ORIGIN + 1] = 2 * high[1] - low[1];
            path[Layout.ORIGIN + 2] = z(i);
            sum += Hit.find(
                    path,
                    scratch,
                    input.view().frame(),
                    input.bodies().floats(),
                    input.bodies().looks(),
                    input.bodies().meshes(),
                    Variant.WALK);
        }
        return sum;
    }

    /** Points of a level through the crowd's middle, under a light straight above. */
    @Benchmark
    @OutputTimeUnit(TimeUnit.NANOSECONDS)
    @OperationsPerInvocation(CALLS)
    public float shadow() {
        path[Layout.TO_LIGHT] = 0f;
        path[Layout.TO_LIGHT + 1] = 1f;
        path[Layout.TO_LIGHT + 2] = 0f;
        path[Layout.LIGHT_DISTANCE] = 2f * (high[1] - low[1]) + 10f * LIGHT_DISC_RADIUS;
        path[Layout.NORMAL_DOT_LIGHT] = 1f;
        float[] bodies = input.bodies().floats().clone();
        bodies[Layout.PLACE_SIZE] = 0.5f * LIGHT_DISC_RADIUS;
        float sum = 0;
        for (int i = 0; i < CALLS; i++) {
            path[Layout.POINT] = x(i);
            path[Layout.POINT + 1] = 0.5f * (low[1] + high[1]);
            path[Layout.POINT + 2] = z(i);
            sum += Shadow.visible(
                    path,
                    Layout.PLANE,
                    scratch,
                    input.view().frame(),
                    bodies,
                    input.bodies().looks(),
                    input.bodies().meshes(),
                    Variant.WALK);
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
