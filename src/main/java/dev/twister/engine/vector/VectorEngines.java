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

/** Offers the engine of SIMD lanes where the JVM was started with the Vector API. */
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

    // Nothing before this names a class that needs the module.
    private static EngineOffer working() {
        int threads = Runtime.getRuntime().availableProcessors();
        return EngineOffer.working(VECTOR, VectorEngine.describe(threads), DESCRIPTION, () -> open(threads));
    }

    /** The engine on that number of threads. */
    static Engine open(int threads) {
        return new VectorEngine(threads, new Ways(VectorEngine.CROWD, SmallRehearsal::of), new Drawing());
    }

    /** The same, which walks the hierarchy from that many bodies on, rehearsed or not. */
    static Engine open(int threads, int crowd) {
        return open(threads, crowd, Shortcuts.all());
    }

    /** The same with some shortcuts. */
    static Engine open(int threads, int crowd, Shortcuts shortcuts) {
        return open(threads, crowd, new Drawing(shortcuts, new Declined(_ -> false)));
    }

    /** The same, which declines some bodies. */
    static Engine open(int threads, int crowd, IntPredicate declined) {
        return open(threads, crowd, new Drawing(Shortcuts.all(), new Declined(declined)));
    }

    private static Engine open(int threads, int crowd, Drawing drawing) {
        return new VectorEngine(threads, new Ways(crowd, _ -> new Unrehearsed()), drawing);
    }
}
