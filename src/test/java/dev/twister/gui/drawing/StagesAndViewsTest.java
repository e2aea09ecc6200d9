package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.world.StageOrView;
import org.junit.jupiter.api.Test;

class StagesAndViewsTest {
    @Test
    void theFullPictureIsOfferedOnce() {
        assertThat(StagesAndViews.all()).doesNotHaveDuplicates().contains(StageOrView.BEAUTY, StageOrView.TESTS);
        assertThat(StagesAndViews.all().stream().map(StagesAndViews::label))
                .contains("Hard shadows", "Reflections (full picture)", "Normal");
    }

    @Test
    void stepsGoRoundAndBack() {
        assertThat(StagesAndViews.along(StageOrView.TESTS, 1)).isEqualTo(StageOrView.COLORS);
        assertThat(StagesAndViews.along(StageOrView.COLORS, -1)).isEqualTo(StageOrView.TESTS);
        assertThat(StagesAndViews.along(StageOrView.BEAUTY, 1)).isEqualTo(StageOrView.ALBEDO);
    }
}
