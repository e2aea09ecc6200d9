package dev.twister.gui.property;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DaylightFileTest {
    @Test
    void theNameTellsTheParameters() {
        DaylightFile sky = new DaylightFile(8, -60, 3.5, 0.25);
        assertThat(sky.name()).isEqualTo("daylight_8_-60_3.5_0.25.hdr");
        assertThat(DaylightFile.of(Path.of("skies", sky.name()))).contains(sky);
        assertThat(new DaylightFile(0, 100, 10, 1).name()).isEqualTo("daylight_0_100_10_1.hdr");
    }

    @Test
    void otherNamesAreOtherSkies() {
        assertThat(DaylightFile.of(Path.of("day.hdr"))).isEmpty();
        assertThat(DaylightFile.of(Path.of("daylight_91_0_3_0.hdr"))).isEmpty();
    }

    @Test
    void theSkyIsWrittenBesideTheScene(@TempDir Path folder) throws IOException {
        Scene scene = new DaylightFile(8, -60, 3, 0).in(Scene.under(Path.of("elsewhere", "day.hdr")));
        Scene moved = DaylightFile.movedBeside(folder.resolve("scene.json"), scene);
        DaylightFile.writeIfMissing(moved);
        assertThat(folder.resolve("daylight_8_-60_3_0.hdr")).exists();
        assertThat(moved.sky().file()).isEqualTo(folder.resolve("daylight_8_-60_3_0.hdr"));
    }
}
