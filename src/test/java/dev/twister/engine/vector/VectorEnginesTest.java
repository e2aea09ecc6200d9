package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.ChildJvm;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

final class VectorEnginesTest {
    @Test
    void isOfferedWithThreadsAndLanes() {
        EngineOffer offer = Engines.offers().stream()
                .filter(candidate -> candidate.id().equals(VectorEngines.VECTOR))
                .findFirst()
                .orElseThrow();
        assertThat(offer.works()).isTrue();
        assertThat(offer.device()).containsPattern("(one thread|\\d+ threads), (4|8|16) lanes");
    }

    @Test
    void saysWhichOptionIsMissing() throws IOException, InterruptedException {
        Process java = ChildJvm.start(ChildJvm.of(ObstacleMain.class).redirectErrorStream(true));
        String output = new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(java.waitFor()).as(output).isZero();
        assertThat(output).contains("--add-modules jdk.incubator.vector");
    }

    /** Prints why the engine is unavailable; runs in a JVM without the Vector API. */
    static final class ObstacleMain {
        private ObstacleMain() {}

        public static void main(String[] arguments) {
            Engines.offers().stream()
                    .filter(offer -> offer.id().equals(VectorEngines.VECTOR))
                    .forEach(offer -> System.out.println(offer.obstacle().orElse("none")));
        }
    }
}
