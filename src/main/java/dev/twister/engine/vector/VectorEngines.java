package dev.twister.engine.vector;

import com.google.auto.service.AutoService;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.EngineProvider;
import dev.twister.engine.SettlingFrames;
import dev.twister.engine.vector.frame.Declined;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.Shortcuts;
import dev.twister.world.SampleWorld;
import java.time.Duration;
import java.util.List;
import java.util.function.IntPredicate;

/** Offers the engine {@code vector} where the JVM was started with the Vector API. */
@AutoService(EngineProvider.class)
public final class VectorEngines implements EngineProvider {
    public static final String VECTOR = "vector";

    private static final String MODULE = "jdk.incubator.vector";
    private static final String DESCRIPTION = "plain Java with the Vector API: packets of pixels in SIMD lanes";

    @Override
    public List<EngineOffer> offers() {
        boolean present = ModuleLayer.boot().findModule(MODULE).isPresent();
        return List.of(
                present
                        ? working()
                        : EngineOffer.impossible(
                                VECTOR,
                                "the CPU's SIMD lanes",
                                DESCRIPTION,
                                "the JVM was started without the Vector API. Start it with --add-modules " + MODULE));
    }

    // The code above must not refer to classes that need the module.
    private static EngineOffer working() {
        int threads = Runtime.getRuntime().availableProcessors();
        return EngineOffer.working(VECTOR, VectorEngine.describe(threads), DESCRIPTION, () -> open(threads));
    }

    /** Opens the engine on a number of threads. */
    public static Engine open(int threads) {
        return new VectorEngine(
                threads,
                new HierarchyChoice(VectorEngine.CROWD, SmallRehearsal::of),
                new PathRehearsal(threads, false),
                new Drawing());
    }

    /** Opens the engine without rehearsals; it uses the hierarchy from {@code crowd} bodies on. */
    public static Engine open(int threads, int crowd) {
        return open(threads, crowd, Shortcuts.all());
    }

    /** As above, with only the given shortcuts. */
    public static Engine open(int threads, int crowd, Shortcuts shortcuts) {
        return open(threads, crowd, new Drawing(shortcuts, new Declined(_ -> false)));
    }

    /** As above; the engine declines the bodies whose numbers match. */
    public static Engine open(int threads, int crowd, IntPredicate declined) {
        return open(threads, crowd, new Drawing(Shortcuts.all(), new Declined(declined)));
    }

    private static Engine open(int threads, int crowd, Drawing drawing) {
        return new VectorEngine(
                threads, new HierarchyChoice(crowd, _ -> new Unrehearsed()), new PathRehearsal(threads, true), drawing);
    }

    /** Renders small frames of many or few spheres on its own thread until the frame time settles. */
    static final class SmallRehearsal implements Rehearsal {
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
                new SettlingFrames(
                                engine,
                                SampleWorld.crowd(spheres, WIDTH, HEIGHT).snapshot())
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

    /** No rehearsal: complete from the start. */
    private record Unrehearsed() implements Rehearsal {
        @Override
        public boolean isOver() {
            return true;
        }

        @Override
        public void close() {
            // Nothing to stop.
        }
    }
}
