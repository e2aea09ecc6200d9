package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.world.FrameInput;
import java.util.Random;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.Tag;
import net.jqwik.api.lifecycle.AfterProperty;

/**
 * Compares every JVM engine on random scenes of glass, rough surfaces, textures and lenses. The bounds are
 * {@link RandomScenesTest}'s: rough surfaces need no looser ones, as engines and oracle use the same sample numbers.
 */
class RandomMaterialsTest {
    private static final int FEW_BOUNCES_PIXELS_AN_EXCUSE = 50_000;
    private static final int MANY_BOUNCES_PIXELS_AN_EXCUSE = 5000;
    private static final String VECTOR = "vector";

    private final PixelJudge judge = new PixelJudge();
    private final ShownWorld world = new ShownWorld();
    private int pixelsAnExcuse = FEW_BOUNCES_PIXELS_AN_EXCUSE;

    @Provide
    Arbitrary<LitScene> fewBounces() {
        return RandomMaterials.ofBounces(0, 3);
    }

    @Provide
    Arbitrary<LitScene> manyBounces() {
        return RandomMaterials.ofBounces(4, 8);
    }

    @Property(seed = "20261125", tries = 250, shrinking = ShrinkingMode.OFF)
    void sequentialDrawsWhatTheOracleDraws(@ForAll("fewBounces") LitScene random) {
        judge(JvmEngines.SEQUENTIAL, random);
    }

    @Property(seed = "20261126", tries = 100, shrinking = ShrinkingMode.OFF)
    void manyBouncesAreWhatTheOracleDraws(@ForAll("manyBounces") LitScene random) {
        pixelsAnExcuse = MANY_BOUNCES_PIXELS_AN_EXCUSE;
        judge(JvmEngines.SEQUENTIAL, random);
    }

    @Property(seed = "20261130", tries = 60, shrinking = ShrinkingMode.OFF)
    void metalsAndEmissionAreWhatTheOracleDraws(@ForAll("fewBounces") LitScene random, @ForAll Random choice) {
        LitScene tinted = RandomMaterials.tinted(random, choice);
        judge(JvmEngines.SEQUENTIAL, tinted);
        judge(VECTOR, tinted);
    }

    /** Follows from the tests of {@code sequential} here and of lanes against it. */
    @Tag("slow")
    @Property(seed = "20261127", tries = 100, shrinking = ShrinkingMode.OFF)
    void vectorDrawsWhatTheOracleDraws(@ForAll("fewBounces") LitScene random) {
        judge(VECTOR, random);
    }

    @Tag("slow")
    @Property(seed = "20261128", tries = 40, shrinking = ShrinkingMode.OFF)
    void vectorDrawsManyBouncesAsTheOracleDoes(@ForAll("manyBounces") LitScene random) {
        pixelsAnExcuse = MANY_BOUNCES_PIXELS_AN_EXCUSE;
        judge(VECTOR, random);
    }

    @Property(seed = "20261129", tries = 100, shrinking = ShrinkingMode.OFF)
    void parallelIsSequentialBitForBit(@ForAll("manyBounces") LitScene random) {
        FrameInput input = world.input(random);
        assertThat(Pictures.argb(JvmEngines.PARALLEL, input)).isEqualTo(Pictures.argb(JvmEngines.SEQUENTIAL, input));
    }

    private void judge(String engine, LitScene scene) {
        judge.judge(Pictures.argb(engine, world.input(scene)), scene);
    }

    @AfterProperty
    void fewPixelsNeededAnExcuse() {
        judge.requireExcusedAtMostOneIn(pixelsAnExcuse);
    }
}
