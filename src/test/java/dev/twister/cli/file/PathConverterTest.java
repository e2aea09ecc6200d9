package dev.twister.cli.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PathConverterTest {
    private static final byte[] NAME = {'a', (byte) 0xFF, ' ', (byte) 0xC3, (byte) 0xB6, '.', 'p', 'n', 'g'};

    @ParameterizedTest
    @CsvSource({"'', /", "--output=, /", "'', ''", "-o=, ''"})
    void bytesThatAreNoTextAreKept(String option, String folder) {
        assumeThat(Path.of("/proc")).exists();
        ByteArrayOutputStream arguments = new ByteArrayOutputStream();
        arguments.writeBytes("java\0render\0".getBytes(StandardCharsets.UTF_8));
        arguments.writeBytes((option + folder).getBytes(StandardCharsets.UTF_8));
        arguments.writeBytes(NAME);
        arguments.write(0);

        Path path =
                new PathConverter(arguments::toByteArray).convert(folder + new String(NAME, StandardCharsets.UTF_8));

        assertThat(path.toUri().toString()).endsWith("/a%FF%20%C3%B6.png");
        assertThat(path.toAbsolutePath().getParent())
                .isEqualTo(folder.isEmpty() ? Path.of("").toAbsolutePath() : Path.of(folder));
    }

    @ParameterizedTest
    @CsvSource({"a\uFFFD.png", "plain.png", "/ö.png"})
    void otherNamesStayAsTheyAre(String name) {
        assertThat(new PathConverter(() -> new byte[0]).convert(name)).isEqualTo(Path.of(name));
    }
}
