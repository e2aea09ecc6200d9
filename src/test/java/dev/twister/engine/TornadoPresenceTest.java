package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.Test;

/** Reports whether this build includes the tests of the TornadoVM engine. */
class TornadoPresenceTest {
    @Test
    void deviceTestsAreBuiltWhereTheEngineWorks() {
        assumeTrue(
                Engines.offers().stream().anyMatch(offer -> Engines.isDevice(offer.id()) && offer.works()),
                "no TornadoVM SDK here: the TornadoVM engine's tests were not built");
        assertThatCode(() -> Class.forName("dev.twister.engine.tornado.ScenesOnDeviceTest"))
                .doesNotThrowAnyException();
    }
}
