package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class TornadoOptionsTest {
    @Test
    void theLauncherSaysTheSame() throws IOException {
        Map<String, String> launchers = Files.readAllLines(Path.of("scripts/tornado.options")).stream()
                .filter(line -> !line.startsWith("#"))
                .map(line -> line.replaceFirst("^-D", "").split("=", 2))
                .collect(Collectors.toMap(option -> option[0], option -> option[1]));

        assertThat(launchers).isEqualTo(TornadoOptions.options(true));
    }

    @Test
    void anotherGraalIsToldByItsOwnPrefix() {
        assertThat(TornadoOptions.options(false))
                .containsEntry("graal.MethodInlineBailoutLimit", "1000000")
                .doesNotContainKey("jdk.graal.MethodInlineBailoutLimit");
    }
}
