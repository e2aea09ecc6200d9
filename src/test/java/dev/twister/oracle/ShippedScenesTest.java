package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.engine.PlainPicture;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every engine of the JVM against the oracle, and against each other, over every shipped scene. */
class ShippedScenesTest {
    /** Of its spheres, 0.2 m wide at 60 m, each reflects the crowd of the others: a rounding moves many edges. */
    private static final String CROWD = "spheres-10000";

    private static final int CROWDS_PIXELS_AN_ODD_ONE = 1000;

    static List<String> names() {
        return ShippedScenes.names();
    }

    @ParameterizedTest
    @MethodSource("names")
    void sequentialDrawsWhatTheOracleDraws(String name) {
        LitScene quick = ShippedScenes.quick(name);
        PixelJudge judge = new PixelJudge();
        judge.judge(Pictures.argb(JvmEngines.SEQUENTIAL, quick.scene(), quick.sky()), quick.scene(), quick.sky());
        judge.requireExcusedAtMostOneIn(
                name.equals(CROWD) ? CROWDS_PIXELS_AN_ODD_ONE : PictureDifference.PIXELS_AN_ODD_ONE);
    }

    @ParameterizedTest
    @MethodSource("names")
    void parallelIsSequentialBitForBit(String name) {
        LitScene quick = ShippedScenes.quick(name);
        assertThat(Pictures.argb(JvmEngines.PARALLEL, quick.scene(), quick.sky()))
                .isEqualTo(Pictures.argb(JvmEngines.SEQUENTIAL, quick.scene(), quick.sky()));
    }

    @ParameterizedTest
    @MethodSource("names")
    void shortcutsAreExact(String name) {
        LitScene quick = ShippedScenes.quick(name);
        PictureDifference difference = PictureDifference.between(
                Pictures.argb(JvmEngines.SEQUENTIAL, quick.scene(), quick.sky()),
                PlainPicture.argb(quick.scene(), quick.sky()));
        assertThat(difference).matches(PictureDifference::isWithinBound, "is within the design's bound");
    }
}
