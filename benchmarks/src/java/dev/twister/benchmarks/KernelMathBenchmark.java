package dev.twister.benchmarks;

import dev.twister.kernel.KernelMath;
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

/** The kernel's own functions beside {@link StrictMath}'s, in nanoseconds a call. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@OperationsPerInvocation(KernelMathBenchmark.CALLS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class KernelMathBenchmark {
    static final int CALLS = 4096;
    private static final float EXPONENT = 48f;

    private final float[] first = new float[CALLS];
    private final float[] second = new float[CALLS];

    @Setup(Level.Trial)
    public void fill() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < CALLS; i++) {
            first[i] = (float) random.nextDouble();
            second[i] = (float) random.nextDouble(-1, 1);
        }
    }

    @Benchmark
    public float kernelPow() {
        float sum = 0;
        for (float base : first) {
            sum += KernelMath.pow(base, EXPONENT);
        }
        return sum;
    }

    @Benchmark
    public double strictPow() {
        double sum = 0;
        for (float base : first) {
            sum += StrictMath.pow(base, EXPONENT);
        }
        return sum;
    }

    @Benchmark
    public float kernelAtan2() {
        float sum = 0;
        for (int i = 0; i < CALLS; i++) {
            sum += KernelMath.atan2(second[i], first[i]);
        }
        return sum;
    }

    @Benchmark
    public double strictAtan2() {
        double sum = 0;
        for (int i = 0; i < CALLS; i++) {
            sum += StrictMath.atan2(second[i], first[i]);
        }
        return sum;
    }

    @Benchmark
    public int kernelFloor() {
        int sum = 0;
        for (float value : second) {
            sum += KernelMath.floor(value * CALLS);
        }
        return sum;
    }

    @Benchmark
    public int strictFloor() {
        int sum = 0;
        for (float value : second) {
            sum += (int) StrictMath.floor(value * CALLS);
        }
        return sum;
    }
}
