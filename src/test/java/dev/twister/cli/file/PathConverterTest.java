package dev.twister.cli.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@EnabledOnOs(OS.LINUX)
class PathConverterTest {
    /** Arguments of their own, and behind an option. */
    @ParameterizedTest
    @ValueSource(strings = {"", "--output="})
    void bytesThatAreNoTextStay(String option) {
        PathConverter converter = new PathConverter(() -> arguments(option));

        assertThat(converter.convert("a\uFFFD\uFFFDb.png").toUri().getRawPath()).endsWith("/a%FF%FEb.png");
        assertThat(converter.convert("/x/\uFFFD.png").toUri().getRawPath()).isEqualTo("/x/%FF.png");
        assertThat(converter.convert("plain.png")).isEqualTo(Path.of("plain.png"));
    }

    private static byte[] arguments(String option) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.writeBytes("java\0render\0".getBytes(StandardCharsets.US_ASCII));
        all.writeBytes(option.getBytes(StandardCharsets.US_ASCII));
        all.writeBytes(new byte[] {'a', (byte) 0xFF, (byte) 0xFE, 'b', '.', 'p', 'n', 'g', 0});
        all.writeBytes(option.getBytes(StandardCharsets.US_ASCII));
        all.writeBytes(new byte[] {'/', 'x', '/', (byte) 0xFF, '.', 'p', 'n', 'g', 0});
        return all.toByteArray();
    }
}
