package dev.twister.engine.vector;

import com.google.auto.service.AutoService;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.EngineProvider;
import dev.twister.engine.vector.frame.Declined;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.Shortcuts;
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
    static Engine open(int threads) {
        return new VectorEngine(
                threads, new Ways(VectorEngine.CROWD, SmallRehearsal::of), new PathRehearsal(false), new Drawing());
    }

    /** Opens the engine without rehearsals; it uses the hierarchy from {@code crowd} bodies on. */
    static Engine open(int threads, int crowd) {
        return open(threads, crowd, Shortcuts.all());
    }

    /** As above, with only the given shortcuts. */
    static Engine open(int threads, int crowd, Shortcuts shortcuts) {
        return open(threads, crowd, new Drawing(shortcuts, new Declined(_ -> false)));
    }

    /** As above; the engine declines the bodies whose numbers match. */
    static Engine open(int threads, int crowd, IntPredicate declined) {
        return open(threads, crowd, new Drawing(Shortcuts.all(), new Declined(declined)));
    }

    private static Engine open(int threads, int crowd, Drawing drawing) {
        return new VectorEngine(threads, new Ways(crowd, _ -> new Unrehearsed()), new PathRehearsal(true), drawing);
    }
}
