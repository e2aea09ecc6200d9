package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.image.Frame;
import dev.twister.oracle.Crowds;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.Pictures;
import dev.twister.oracle.RandomScenes;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.Arrays;
import java.util.Random;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.ShrinkingMode;
import org.junit.jupiter.api.Test;

class JvmEnginesTest {
    @Provide
    Arbitrary<LitScene> scenes() {
        return RandomScenes.upToBounces(8);
    }

    @Property(seed = "20261121", tries = 40, shrinking = ShrinkingMode.OFF)
    void parallelIsSequentialBitForBit(@ForAll("scenes") LitScene random) {
        assertThat(Pictures.argb(JvmEngines.PARALLEL, random.scene(), random.sky()))
                .isEqualTo(Pictures.argb(JvmEngines.SEQUENTIAL, random.scene(), random.sky()));
    }

    @Property(seed = "20261121", tries = 40, shrinking = ShrinkingMode.OFF)
    void linearParallelIsSequentialBitForBit(@ForAll("scenes") LitScene random) {
        assertThat(Pictures.radiance(JvmEngines.PARALLEL, random.scene(), random.sky()))
                .isEqualTo(Pictures.radiance(JvmEngines.SEQUENTIAL, random.scene(), random.sky()));
    }

    @Property(seed = "20261121", tries = 40, shrinking = ShrinkingMode.OFF)
    void bandsMakeTheWholePictureBitForBit(@ForAll("scenes") LitScene random) {
        FrameInput whole = World.of(random.scene(), random.sky()).snapshot();
        int split = Math.ceilDiv(whole.height(), 3);
        int[] joined = new int[whole.width() * whole.height()];
        for (int row = 0; row < whole.height(); row += split) {
            FrameInput band = whole.band(row, Math.min(split, whole.height() - row));
            int[] pixels = Pictures.argb(JvmEngines.SEQUENTIAL, band);
            System.arraycopy(pixels, 0, joined, row * whole.width(), pixels.length);
        }
        assertThat(joined).isEqualTo(Pictures.argb(JvmEngines.SEQUENTIAL, whole));
    }

    @Property(seed = "20261121", tries = 20, shrinking = ShrinkingMode.OFF)
    void renderingAgainGivesTheSameBits(@ForAll("scenes") LitScene random) {
        FrameInput input = World.of(random.scene(), random.sky()).snapshot();
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        try (Engine engine = Engines.open(JvmEngines.PARALLEL)) {
            engine.render(input, frame);
            int[] first = frame.argb().clone();
            Arrays.fill(frame.argb(), 0);
            engine.render(input, frame);
            assertThat(frame.argb()).isEqualTo(first);
        }
    }

    /** A hierarchy with all spheres in one leaf is the brute-force loop. */
    @Property(seed = "20261121", tries = 60, shrinking = ShrinkingMode.OFF)
    void hierarchyDrawsWhatThePlainLoopDrawsBitForBit(@ForAll("scenes") LitScene random) {
        FrameInput input = World.of(random.scene(), random.sky()).snapshot();
        int[] plain = Pictures.argb(JvmEngines.SEQUENTIAL, input.withLeavesOf(Integer.MAX_VALUE));
        for (int mostInLeaf = 1; mostInLeaf < 4; mostInLeaf++) {
            assertThat(Pictures.argb(JvmEngines.SEQUENTIAL, input.withLeavesOf(mostInLeaf)))
                    .isEqualTo(plain);
        }
    }

    @Test
    void hierarchyDrawsACrowdAsThePlainLoopDoesBitForBit() {
        FrameInput input = Crowds.world(3000, 160, 90).snapshot();
        assertThat(Pictures.argb(JvmEngines.PARALLEL, input))
                .isEqualTo(Pictures.argb(JvmEngines.PARALLEL, input.withLeavesOf(Integer.MAX_VALUE)));
    }

    @Test
    void timesAreNoted() {
        LitScene random = RandomScenes.scene(new Random(2), 2);
        FrameInput input = World.of(random.scene(), random.sky()).snapshot();
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        try (Engine engine = Engines.open(JvmEngines.SEQUENTIAL)) {
            engine.render(input, frame);
        }
        assertThat(frame.times().totalNanos()).isPositive();
    }
}
