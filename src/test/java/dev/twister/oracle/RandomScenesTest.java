package dev.twister.oracle;

import dev.twister.engine.JvmEngines;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.lifecycle.AfterProperty;

/** The kernel, with its shortcuts and without, against the oracle on random scenes; jqwik reports the seed of a failure. */
class RandomScenesTest {
    /** The design's bound, over all tries together. */
    private static final int FEW_BOUNCES_PIXELS_AN_EXCUSE = 5000;

    /**
     * Each bounce off a sphere widens a difference by about its distance over its radius: after eight, the rounding of a
     * float is as wide as a body, and the pixel is anyone's.
     */
    private static final int MANY_BOUNCES_PIXELS_AN_EXCUSE = 500;

    private final PixelJudge judge = new PixelJudge();
    private int pixelsAnExcuse = FEW_BOUNCES_PIXELS_AN_EXCUSE;

    @Provide
    Arbitrary<RandomScene> fewBounces() {
        return RandomScenes.upToBounces(3);
    }

    @Provide
    Arbitrary<RandomScene> manyBounces() {
        return RandomScenes.ofManyBounces();
    }

    @Property(tries = 250, shrinking = ShrinkingMode.OFF)
    void shortcutsDrawWhatTheOracleDraws(@ForAll("fewBounces") RandomScene random) {
        judge.judge(Pictures.argb(JvmEngines.SEQUENTIAL, random.scene(), random.sky()), random.scene(), random.sky());
    }

    @Property(tries = 100, shrinking = ShrinkingMode.OFF)
    void plainEquationsDrawWhatTheOracleDraws(@ForAll("fewBounces") RandomScene random) {
        judge.judge(Pictures.argb(JvmEngines.PLAIN, random.scene(), random.sky()), random.scene(), random.sky());
    }

    @Property(tries = 150, shrinking = ShrinkingMode.OFF)
    void manyBouncesAreWhatTheOracleDraws(@ForAll("manyBounces") RandomScene random) {
        pixelsAnExcuse = MANY_BOUNCES_PIXELS_AN_EXCUSE;
        judge.judge(Pictures.argb(JvmEngines.SEQUENTIAL, random.scene(), random.sky()), random.scene(), random.sky());
    }

    @AfterProperty
    void fewPixelsNeededAnExcuse() {
        System.err.println("EXCUSED " + judge.excused() + " of " + judge.pixels());
        judge.requireExcusedAtMostOneIn(pixelsAnExcuse);
    }
}
