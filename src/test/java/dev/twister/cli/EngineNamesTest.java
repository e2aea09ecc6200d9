package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.UnknownEngineException;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class EngineNamesTest {
    private static final List<EngineOffer> OFFERS = Stream.of("sequential", "tornado:0:0", "tornado:0:1")
            .map(id -> EngineOffer.impossible(id, "a device", "draws", "nothing"))
            .toList();

    @Test
    void aDeviceOfTwoNamesIsTakenOnce() {
        List<String> names = List.of("tornado", "sequential", "tornado:0:0", "tornado:0:1", "sequential");

        assertThat(EngineNames.resolve(names, OFFERS)).containsExactly("tornado:0:0", "sequential", "tornado:0:1");
    }

    @Test
    void anUnknownNameIsToldTheKnownOnes() {
        assertThatThrownBy(() -> EngineNames.resolve(List.of("sequential", "warp"), OFFERS))
                .isInstanceOf(UnknownEngineException.class)
                .hasMessage("--engine is 'warp', but must be one of sequential, tornado:0:0, tornado:0:1");
    }
}
