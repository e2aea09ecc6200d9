package dev.twister.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HdrNotesTest {
    private static final Provenance MADE = new Provenance("Twister", "picture", "0-3");

    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void writePicture() throws IOException {
        file = folder.resolve("a.hdr");
        HdrWriter.write(file, 12, 5, new float[3 * 12 * 5], MADE);
    }

    @Test
    void tellHowAWholePictureWasMade() throws IOException {
        assertThat(Provenance.ofFile(file, 0, 5)).isEqualTo(Optional.of(MADE));
    }

    @ParameterizedTest
    @ValueSource(strings = {"-Y 5 +X", "-Y 1e30 +X 12", "-Y 99999999999 +X 12", "+X 12", "-Y 999999999 +X 12", ""})
    void areRefusedIfTheResolutionLineIsDamaged(String line) throws IOException {
        String text = Files.readString(file, StandardCharsets.ISO_8859_1).replace("-Y 5 +X 12", line);
        Files.writeString(file, text, StandardCharsets.ISO_8859_1);

        assertThatIOException().isThrownBy(() -> Provenance.ofFile(file, 0, 5));
    }

    @Test
    void areRefusedIfTheLastRowIsMissing() throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        Files.write(file, Arrays.copyOf(bytes, bytes.length - 4));

        assertThatIOException().isThrownBy(() -> Provenance.ofFile(file, 0, 5));
    }

    @Test
    void filesOfAnotherEndingAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Provenance.ofFile(folder.resolve("a.tif"), 0, 5))
                .withMessageEndingWith("a.tif does not end in .png, .hdr or .exr");
    }
}
