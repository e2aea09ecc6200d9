package dev.twister.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class JitRunsTest {
    @Test
    void theChildIsToldAllButTheCompilersAndTheReport() {
        JitRuns runs = new JitRuns(
                "Main",
                List.of(
                        "benchmark",
                        "--jit",
                        "c2",
                        "--jit=graal",
                        "--json",
                        "--jit",
                        "--quick",
                        "--json=a",
                        "mirrors"));

        assertThat(runs.childArguments(Path.of("r.json")))
                .containsExactly("benchmark", "--quick", "mirrors", "--json", "r.json");
    }
}
