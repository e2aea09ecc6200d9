package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TornadoEnginesTest {
    private final Throwable problem =
            new ExceptionInInitializerError(new IllegalStateException("\u001B[31mno platform found\u001B[0m"));

    @Test
    void whoHasTheOptionsIsToldOfTheDriver() {
        assertThat(TornadoEngines.explain(problem, true))
                .contains("(IllegalStateException: no platform found)", "Install a driver")
                .doesNotContain("scripts/twister");
    }

    @Test
    void whoHasThemNotIsToldOfTheLauncher() {
        assertThat(TornadoEngines.explain(problem, false))
                .contains("(IllegalStateException: no platform found)", "Start with scripts/twister");
    }
}
