package dev.twister.benchmarks;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.scene.Rendering;
import dev.twister.world.FrameInput;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** A whole frame, from the snapshot to the pixels in the caller's array, in milliseconds. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class FrameBenchmark {
    @Param({"sequential", "parallel"})
    String engine;

    /** Width x height. */
    @Param({"1280x720"})
    String size;

    @Param({"1", "200"})
    int shadowSamples;

    @Param({"1", "3"})
    int bounces;

    @Param({"5", "100"})
    int spheres;

    private Engine opened;
    private FrameInput input;
    private Frame frame;

    @Setup(Level.Trial)
    public void open() {
        String[] sides = size.split("x", 2);
        Rendering settings = Rendering.DEFAULT
                .withSize(Integer.parseInt(sides[0]), Integer.parseInt(sides[1]))
                .withShadowSamples(shadowSamples)
                .withBounces(bounces);
        input = BenchmarkScene.withSpheres(spheres, settings).snapshot();
        frame = Frame.ofPixels(input.width(), input.height());
        opened = Engines.open(engine);
    }

    @TearDown(Level.Trial)
    public void close() {
        opened.close();
    }

    @Benchmark
    public int frame() {
        opened.render(input, frame);
        return frame.argb()[0];
    }
}
