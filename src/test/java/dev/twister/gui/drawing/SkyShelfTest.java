package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.sky.PngBytes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SkyShelfTest {
    @TempDir
    Path folder;

    @Test
    void givesWarningsOnce() throws IOException {
        byte[] image = PngBytes.start(1, 8, PngBytes.GRAY)
                .damagedChunk("gAMA", new byte[4])
                .texels(0);
        Path file = Files.write(folder.resolve("sky.png"), image);
        SkyShelf shelf = new SkyShelf();
        shelf.refresh(file);
        shelf.find(file);
        assertThat(shelf.takeWarnings()).isEqualTo(file + ": the gAMA chunk is damaged and is ignored");
        assertThat(shelf.takeWarnings()).isEmpty();
    }
}
