package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Compares every JVM engine on random scenes with meshes of all materials. */
class RandomMeshesTest {
    private static final int SCENES = 50;
    private static final int FEW = 12;

    /** Triangles of a few pixels have many edges. */
    private static final int PIXELS_AN_EXCUSE = 2000;

    @Test
    void sequentialDrawsWhatTheOracleDraws() {
        PixelJudge judge = new PixelJudge();
        for (int seed = 0; seed < SCENES; seed++) {
            Random random = new Random(seed);
            LitScene scene = RandomMeshes.scene(random, random.nextInt(5));
            judge.judge(Pictures.argb(JvmEngines.SEQUENTIAL, scene), scene);
        }
        judge.requireExcusedAtMostOneIn(PIXELS_AN_EXCUSE);
    }

    @Test
    void parallelIsSequentialBitForBit() {
        for (int seed = 0; seed < FEW; seed++) {
            LitScene scene = RandomMeshes.scene(new Random(seed), 3);
            assertThat(Pictures.argb(JvmEngines.PARALLEL, scene))
                    .isEqualTo(Pictures.argb(JvmEngines.SEQUENTIAL, scene));
        }
    }
}
