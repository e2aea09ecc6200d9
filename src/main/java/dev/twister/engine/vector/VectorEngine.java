package dev.twister.engine.vector;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.FrameFit;
import dev.twister.engine.ProcessorTime;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.threads.Crew;
import dev.twister.threads.Turns;
import dev.twister.world.FrameInput;
import java.util.Arrays;
import java.util.function.IntConsumer;

/** Renders tiles in SIMD lanes on several threads. Once warm, a frame allocates only its {@link FrameTimes}. */
final class VectorEngine implements Engine {
    /** Body count from which the hierarchy is faster than brute force; see {@code docs/decisions/010}. */
    static final int CROWD = 250;

    /** Adjacent tiles share cache lines, and each turn waits for a thread's stores, so a turn covers several tiles. */
    private static final int LEAST_TILES_A_TURN = 4;

    private final int threads;
    private final HierarchyChoice ways;
    private final TileRenderer[] renderers;
    private final Drawing drawing;
    private final Turns turns;
    private final IntConsumer[] tileTasks;
    private final Crew crew;
    private final long[] processorNanos;

    static {
        StageInlining.ensure();
    }

    /**
     * Starts the threads.
     *
     * @param ways closed together with the engine
     * @param rehearsal of made lanes
     * @param drawing holds the state of the current frame
     */
    VectorEngine(int threads, HierarchyChoice ways, PathRehearsal rehearsal, Drawing drawing) {
        this.drawing = drawing;
        this.threads = threads;
        this.ways = ways;
        renderers = new TileRenderer[threads];
        Arrays.setAll(renderers, thread -> new TileRenderer(rehearsal, thread == 0));
        tileTasks = new IntConsumer[threads];
        Arrays.setAll(tileTasks, thread -> tile -> renderers[thread].draw(drawing, tile));
        turns = new Turns(threads, LEAST_TILES_A_TURN);
        processorNanos = new long[threads];
        crew = new Crew("vector", threads, thread -> {
            long start = ProcessorTime.ofThisThread();
            turns.take(tileTasks[thread]);
            processorNanos[thread] = ProcessorTime.ofThisThread() - start;
        });
    }

    /** The text of {@link #device} for a number of threads. */
    static String describe(int threads) {
        return (threads == 1 ? "one thread" : threads + " threads") + ", " + Lanes.COUNT + " lanes";
    }

    @Override
    public String id() {
        return VectorEngines.VECTOR;
    }

    @Override
    public String device() {
        return describe(threads);
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        FrameFit.check(input, frame);
        long start = System.nanoTime();
        drawing.take(input, frame, ways.walk(input));
        for (TileRenderer renderer : renderers) {
            renderer.start(drawing);
        }
        turns.start(drawing.tiles());
        try {
            crew.work();
        } catch (IllegalStateException e) {
            throw new EngineException("engine vector: " + e.getMessage(), e);
        }
        drawing.stop.check();
        long processor = 0;
        for (long nanos : processorNanos) {
            processor += nanos;
        }
        frame.setTimes(FrameTimes.onJvm(System.nanoTime() - start, processor));
    }

    @Override
    public boolean drawsBandsInProportion() {
        return true;
    }

    @Override
    public boolean declines(FrameInput input) {
        return drawing.declines(input, ways.walk(input));
    }

    @Override
    public void rest() {
        ways.rest();
    }

    @Override
    public void close() {
        ways.close();
        crew.close();
    }
}
