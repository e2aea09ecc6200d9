package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EnginesTest {
    @ParameterizedTest
    @ValueSource(strings = {"sequential", "parallel"})
    void jvmsEnginesAlwaysWork(String id) {
        try (Engine engine = Engines.open(id)) {
            assertThat(engine.id()).isEqualTo(id);
            assertThat(engine.device()).isNotBlank();
        }
    }

    @Test
    void unknownNameIsToldTheKnownOnes() {
        assertThatThrownBy(() -> Engines.offer("warp"))
                .isInstanceOf(UnknownEngineException.class)
                .hasMessageStartingWith("no engine is called 'warp'; there are sequential, parallel");
    }

    @Test
    void aFamilysNameAloneIsItsFirstDevice() {
        List<EngineOffer> offers = Stream.of("sequential", "tornado:0:0", "tornado:0:1")
                .map(id -> EngineOffer.impossible(id, "a device", "draws", "nothing"))
                .toList();

        assertThat(Engines.find(offers, "tornado").map(EngineOffer::id)).contains("tornado:0:0");
        assertThat(Engines.find(offers, "tornado:0:1").map(EngineOffer::id)).contains("tornado:0:1");
        assertThat(Engines.find(offers, "tornado:0")).isEmpty();
    }

    @Test
    void offersNameEachEngineOnce() {
        assertThat(Engines.offers().stream().map(EngineOffer::id)).doesNotHaveDuplicates();
    }

    @Test
    void tornadoIsOfferedOrSaidToBeMissing() {
        assertThat(Engines.offers()).anyMatch(offer -> offer.id().startsWith("tornado"));
    }

    @Test
    void openingTheImpossibleSaysWhy() {
        EngineOffer offer = EngineOffer.impossible("warp", "a warp core", "folds space", "no dilithium");
        assertThat(offer.works()).isFalse();
        assertThatThrownBy(() -> offer.opener().get())
                .isInstanceOf(EngineException.class)
                .hasMessage("engine warp does not work here: no dilithium");
        assertThatThrownBy(offer::check)
                .isInstanceOf(EngineException.class)
                .hasMessage("engine warp does not work here: no dilithium");
    }

    @Test
    void noDeviceIsLookedForWhereItNeedNotBe() {
        assertThat(Engines.offersAtOnce().stream().map(EngineOffer::id))
                .contains("parallel", "auto")
                .noneMatch(Engines::isDevice);
    }
}
