package dev.twister.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class NumberedFilesTest {
    @Test
    void aPartOfAFilmHasTheDigitsOfAll() {
        for (String name : new String[] {"f.png", "f-####.png", "f-%04d.png"}) {
            assertThat(files(name, FrameRange.of(7, 7)).file(7)).hasFileName("f-0007.png");
            assertThat(files(name, FrameRange.of(7, 9999)).file(7)).hasFileName("f-0007.png");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"f.png", "f-####.png"})
    void tenThousandFramesKeepTheirOrder(String name) {
        NumberedFiles files = files(name, FrameRange.ofCount(10_000));

        List<String> names = FrameRange.ofCount(10_000)
                .numbers()
                .mapToObj(number -> files.file(number).toString())
                .toList();
        assertThat(names).isSorted().doesNotHaveDuplicates();
    }

    @Test
    void refusesNumbersThatWouldBreakTheOrder() {
        assertThatExceptionOfType(IllegalArgumentException.class)
                .isThrownBy(() -> files("f-####.png", FrameRange.of(9990, 10_000)))
                .withMessageContaining("frame 10000 needs 5 digits; write #####");
        assertThat(files("f-%d.png", FrameRange.of(9990, 10_000)).file(10_000)).hasFileName("f-10000.png");
    }

    @Test
    void findsThoseThatAreThere(@TempDir Path folder) throws IOException {
        for (String name : new String[] {"f-0003.png", "f-0011.png", "f-12.png", "f-0013.exr", "g-0014.png"}) {
            Files.createFile(folder.resolve(name));
        }

        NumberedFiles files = NumberedFiles.of(folder.resolve("f-####.png"), FrameRange.of(0, 0));

        assertThat(files.existing().keySet()).containsExactly(3, 11);
    }

    private static NumberedFiles files(String name, FrameRange frames) {
        return NumberedFiles.of(Path.of(name), frames);
    }
}
