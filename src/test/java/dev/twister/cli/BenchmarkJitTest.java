package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BenchmarkJitTest {
    @TempDir
    private Path folder;

    @Test
    void aJvmLikeThisOneMeasures() {
        Path json = folder.resolve("jit.json");

        Outcome outcome = Outcome.of(
                "benchmark",
                "teaching",
                "--jit=c2",
                "--engine=parallel",
                "--size=32x18",
                "--classic",
                "--warmup=0",
                "--frames=1",
                "--json=" + json);

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.exitCode()).isZero();
        assertThat(outcome.out()).contains("c2: C2, ", "FPS c2", "32x18");
        assertThat(json).content().contains("\"c2\" : {", "\"passed\" : true");
    }
}
