package dev.twister.cli.file;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.cli.Outcome;
import dev.twister.sky.PngBytes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SkyWarningTest {
    @TempDir
    Path folder;

    @Test
    void tellsWhatASkyFileSaysAndIsNotUsed() throws IOException {
        Path sky = folder.resolve("sky.png");
        byte[] image = PngBytes.start(1, 8, PngBytes.GRAY)
                .damagedChunk("gAMA", new byte[4])
                .texels(0);
        Files.write(sky, image);

        Outcome outcome = Outcome.of(
                "scene",
                "--spheres",
                "1",
                "--skybox",
                sky.toString(),
                "-o",
                folder.resolve("a.json").toString());

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.OK);
        assertThat(outcome.err())
                .isEqualToNormalizingNewlines(
                        "twister: warning: " + sky + ": the gAMA chunk is damaged and is ignored\n");
    }
}
