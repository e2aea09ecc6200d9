package dev.twister.gui.model;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.world.StageOrView;
import org.junit.jupiter.api.Test;

class ShownPicturesTest {
    @Test
    void theFullPictureIsOfferedOnce() {
        assertThat(ShownPictures.all()).doesNotHaveDuplicates().contains(StageOrView.BEAUTY, StageOrView.TESTS);
        assertThat(ShownPictures.all().stream().map(ShownPictures::label))
                .contains("Hard shadows", "Reflections (full picture)", "Normal");
    }

    @Test
    void stepsGoRoundAndBack() {
        assertThat(ShownPictures.along(StageOrView.TESTS, 1)).isEqualTo(StageOrView.COLORS);
        assertThat(ShownPictures.along(StageOrView.COLORS, -1)).isEqualTo(StageOrView.TESTS);
        assertThat(ShownPictures.along(StageOrView.BEAUTY, 1)).isEqualTo(StageOrView.ALBEDO);
    }
}
