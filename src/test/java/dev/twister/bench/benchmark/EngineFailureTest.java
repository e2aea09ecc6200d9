package dev.twister.bench.benchmark;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class EngineFailureTest {
    private static final long MEGABYTE = 1 << 20;

    @ParameterizedTest
    @CsvSource({"512, 8g", "4096, 8g", "16384, 32g", "16500, 34g"})
    void advisesMoreMemoryThanTheJvmHas(long megabytes, String advice) {
        assertThat(EngineFailure.outOfMemory(megabytes * MEGABYTE)).endsWith("-Xmx" + advice);
    }
}
