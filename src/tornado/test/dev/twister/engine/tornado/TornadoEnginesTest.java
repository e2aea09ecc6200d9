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

    @Test
    void whatTornadoSaysOfSequentialExecutionIsLeftOut() {
        Throwable bailout = new IllegalStateException(
                "\u001B[33m[WARNING] No OpenCL platforms found. Deoptimizing to sequential execution.\u001B[0m");

        assertThat(TornadoEngines.explain(bailout, true))
                .contains("(IllegalStateException: No OpenCL platforms found)", "Install a driver");
    }

    @Test
    void theDriversVersionIsALineOfWhatTornadoTells() {
        assertThat(TornadoEngines.driverVersion(
                        "Device version   : OpenCL 3.0\nDriver version   : 3.1+debian \nEndianness: big"))
                .contains("3.1+debian");
        assertThat(TornadoEngines.driverVersion("deviceName=a card")).isEmpty();
        assertThat(TornadoEngines.driverVersion("Driver version   : \nOpenCL C version : 1.2"))
                .isEmpty();
    }
}
