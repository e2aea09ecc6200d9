package dev.twister.sky;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.image.HdrWriter;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ShippedSkyTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @EnumSource(ShippedSky.class)
    void theFileIsWhatTheParametersDraw(ShippedSky shipped) throws IOException {
        Skybox drawn = shipped.draw();
        Path again = folder.resolve(shipped.fileName());
        HdrWriter.write(again, drawn.width(), drawn.height(), drawn.radiance());
        assertThat(Path.of("skyboxes", shipped.fileName())).hasSameBinaryContentAs(again);
    }

    @ParameterizedTest
    @EnumSource(ShippedSky.class)
    void theFileReadsBackAsItWasDrawn(ShippedSky shipped) {
        float[] drawn = shipped.draw().radiance();
        float[] read =
                SkyboxReader.read(Path.of("skyboxes", shipped.fileName())).radiance();
        assertThat(read).hasSameSizeAs(drawn);
        for (int i = 0; i < read.length; i += 3) {
            float largest = Math.max(drawn[i], Math.max(drawn[i + 1], drawn[i + 2]));
            for (int channel = 0; channel < 3; channel++) {
                if (Math.abs(read[i + channel] - drawn[i + channel]) > largest / 256) {
                    throw new AssertionError(
                            "channel " + (i + channel) + ": " + read[i + channel] + " for " + drawn[i + channel]);
                }
            }
        }
    }
}
