package dev.twister.scene.format.json;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SourceFileTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({
        "UTF-16LE, UTF-16",
        "UTF-16BE, UTF-16",
        "UTF-16, UTF-16",
        "x-UTF-16LE-BOM, UTF-16",
        "UTF-32LE, UTF-32",
        "UTF-32BE, UTF-32",
        "X-UTF-32LE-BOM, UTF-32"
    })
    void namesTheEncodingThatAFileHas(String charset, String named) throws IOException {
        Path file = folder.resolve("scene.json");
        Files.write(file, "\n{\"version\": 1}".getBytes(Charset.forName(charset)));
        assertThatThrownBy(() -> SourceFile.read(file))
                .hasMessage(file + ": is not UTF-8 text but " + named + "; save it as UTF-8");
    }

    @ParameterizedTest
    @ValueSource(strings = {"0x10", "0XFF", "-0x1"})
    void saysThatNumbersAreDecimal(String number) throws IOException {
        Path file = Files.writeString(folder.resolve("scene.json"), "{\"version\": " + number + "}");
        assertThatThrownBy(() -> LocatedTree.parse(SourceFile.read(file)))
                .hasMessageEndingWith("numbers must be decimal, not hexadecimal");
    }
}
