package dev.twister.engine;

import com.google.auto.service.AutoService;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.List;
import java.util.stream.IntStream;

/** The engines that need nothing but the JVM: the paper's two baselines. */
@AutoService(EngineProvider.class)
public final class JvmEngines implements EngineProvider {
    public static final String SEQUENTIAL = "sequential";
    public static final String PARALLEL = "parallel";

    /** The engine that opens at once everywhere, and uses the whole processor. */
    public static EngineOffer parallel() {
        int threads = Runtime.getRuntime().availableProcessors();
        return offer(
                PARALLEL,
                threads == 1 ? "one thread of this JVM" : threads + " threads of this JVM",
                "plain Java, a parallel stream over the rows",
                JvmEngines::drawInParallel);
    }

    @Override
    public List<EngineOffer> offers() {
        return List.of(
                offer(SEQUENTIAL, "one thread of this JVM", "plain Java, one thread", JvmEngines::drawInTurn),
                parallel());
    }

    private static EngineOffer offer(String id, String device, String description, JvmEngine.Rows rows) {
        return EngineOffer.working(id, device, description, () -> new JvmEngine(id, device, rows));
    }

    private static void drawInTurn(FrameInput input, Frame frame) {
        for (int row = 0; row < frame.height(); row++) {
            JvmKernel.drawRow(input, frame, row);
        }
    }

    private static void drawInParallel(FrameInput input, Frame frame) {
        RowSpread rows = new RowSpread(frame.height());
        IntStream.range(0, frame.height())
                .parallel()
                .forEach(index -> JvmKernel.drawRow(input, frame, rows.row(index)));
    }
}
