package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

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
