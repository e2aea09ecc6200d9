package dev.twister.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.bench.Statistics;
import dev.twister.scene.Rendering;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class WindowRatesTest {
    @Test
    void fileHasTheRateAndTheDisplay(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("window.json");
        new WindowRates(
                        "vector",
                        "2 threads",
                        Rendering.DEFAULT,
                        Statistics.ofNanos(20_000_000, 30_000_000),
                        50,
                        new WindowRates.Display(1600, 1000, 1, false, 60))
                .write("benchmark", file);

        JsonNode tree = JsonMapper.shared().readTree(Files.readString(file));
        assertThat(tree.at("/parameters/scene").stringValue()).isEqualTo("benchmark");
        assertThat(tree.at("/results/0/fps").doubleValue()).isEqualTo(40);
        assertThat(tree.at("/results/0/width").intValue()).isEqualTo(1280);
        assertThat(tree.at("/display/pipeline").stringValue()).isEqualTo("software");
        assertThat(tree.at("/display/pulsesPerSecond").doubleValue()).isEqualTo(60);
    }
}
