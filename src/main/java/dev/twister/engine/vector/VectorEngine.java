package dev.twister.engine.vector;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.FrameFit;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.threads.Crew;
import dev.twister.world.FrameInput;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;

/** Draws tiles in SIMD lanes on some threads; once warm, a frame allocates nothing but its times. */
final class VectorEngine implements Engine {
    /** With fewer bodies, a look at all of them a tile is faster; measured, see {@code benchmarks/NOTES.md}. */
    static final int CROWD = 250;

    /** Taking turns waits until a thread's pixels are in memory, so not for each tile. */
    private static final int TILES_A_TURN = 4;

    private final int threads;
    private final Ways ways;
    private final TileRenderer[] renderers;
    private final Drawing drawing = new Drawing();
    private final AtomicInteger nextTile = new AtomicInteger();
    private final Crew crew;

    /**
     * Starts the threads.
     *
     * @param ways which are closed with the engine
     */
    VectorEngine(int threads, Ways ways) {
        this.threads = threads;
        this.ways = ways;
        renderers = new TileRenderer[threads];
        Arrays.setAll(renderers, thread -> new TileRenderer());
        crew = new Crew("vector", threads, this::drawTiles);
    }

    /** What {@link #device} says of so many threads. */
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
        nextTile.set(0);
        try {
            crew.work();
        } catch (IllegalStateException e) {
            throw new EngineException("engine vector: " + e.getMessage(), e);
        }
        frame.setTimes(FrameTimes.onJvm(System.nanoTime() - start));
    }

    private void drawTiles(int thread) {
        TileRenderer renderer = renderers[thread];
        int tiles = drawing.tiles();
        int first = nextTile.getAndAdd(TILES_A_TURN);
        while (first < tiles) {
            for (int tile = first; tile < Math.min(first + TILES_A_TURN, tiles); tile++) {
                renderer.draw(drawing, tile);
            }
            first = nextTile.getAndAdd(TILES_A_TURN);
        }
    }

    @Override
    public boolean drawsBandsInProportion() {
        return true;
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
