package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.engine.PlainPicture;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares every JVM engine with the oracle and with the other engines on every shipped scene. */
class ShippedScenesTest {
    /** Its spheres, 0.2 m wide at 60 m, reflect the crowd of others, so rounding moves many edges. */
    private static final String CROWD = "spheres-10000";

    private static final int CROWDS_PIXELS_AN_ODD_ONE = 1000;

    /** Of the few pixels, some are on the edges of triangles. */
    private static final int MESHES_PIXELS_AN_ODD_ONE = 144;

    static List<String> names() {
        return ShippedScenes.names();
    }

    static List<String> oracleNames() {
        return ShippedScenes.quickOracleNames();
    }

    @ParameterizedTest
    @MethodSource("oracleNames")
    void sequentialDrawsWhatTheOracleDraws(String name) {
        LitScene quick = ShippedScenes.quick(name);
        PixelJudge judge = new PixelJudge();
        judge.judge(Pictures.argb(JvmEngines.SEQUENTIAL, quick), quick);
        int pixelsAnOddOne = name.equals(CROWD) ? CROWDS_PIXELS_AN_ODD_ONE : PictureDifference.PIXELS_AN_ODD_ONE;
        judge.requireExcusedAtMostOneIn(quick.scene().meshes().isEmpty() ? pixelsAnOddOne : MESHES_PIXELS_AN_ODD_ONE);
    }

    @ParameterizedTest
    @MethodSource("names")
    void parallelIsSequentialBitForBit(String name) {
        LitScene quick = ShippedScenes.quick(name);
        assertThat(Pictures.argb(JvmEngines.PARALLEL, quick)).isEqualTo(Pictures.argb(JvmEngines.SEQUENTIAL, quick));
    }

    /** Scenes without meshes and without materials that the brute-force reference does not support. */
    static List<String> plainNames() {
        return ShippedScenes.names().stream()
                .filter(name -> isPlain(ShippedScenes.quick(name)))
                .toList();
    }

    private static boolean isPlain(LitScene scene) {
        return scene.scene().meshes().isEmpty()
                && scene.world().snapshot().bodies().plain();
    }

    @ParameterizedTest
    @MethodSource("plainNames")
    void shortcutsAreExact(String name) {
        LitScene quick = ShippedScenes.quick(name);
        PictureDifference difference = PictureDifference.between(
                Pictures.argb(JvmEngines.SEQUENTIAL, quick), PlainPicture.argb(quick.scene(), quick.sky()));
        assertThat(difference).matches(PictureDifference::isWithinBound, "is within the design's bound");
    }
}
