package dev.twister.engine.vector;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.SettlingFrames;
import dev.twister.world.SampleWorld;
import java.time.Duration;

/** Renders small frames of many or few spheres on its own thread until the frame time settles. */
final class SmallRehearsal implements Rehearsal {
    private static final int MANY = 1000;
    private static final int FEW = 5;
    private static final int WIDTH = 320;
    private static final int HEIGHT = 180;

    /** Limits the rehearsal where the JIT compiler stays busy with other code. */
    private static final Duration LONGEST = Duration.ofSeconds(5);

    private final int spheres;
    private volatile boolean over;

    private SmallRehearsal(int spheres) {
        this.spheres = spheres;
        Thread.ofPlatform().daemon().name("twister-rehearsal").start(this::draw);
    }

    /** See {@link Rehearsal.Start#of}. */
    static Rehearsal of(boolean walk) {
        return new SmallRehearsal(walk ? MANY : FEW);
    }

    private void draw() {
        try (Engine engine = VectorEngines.open(1, VectorEngine.CROWD)) {
            new SettlingFrames(engine, SampleWorld.crowd(spheres, WIDTH, HEIGHT).snapshot())
                    .settle(LONGEST, () -> over);
        } catch (EngineException | OutOfMemoryError _) {
            // The next regular frame fails in the same way and reports it.
        } finally {
            over = true;
        }
    }

    @Override
    public boolean isOver() {
        return over;
    }

    @Override
    public void close() {
        over = true;
    }
}
