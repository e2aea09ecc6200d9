package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.world.Picture;
import org.junit.jupiter.api.Test;

class StagesAndViewsTest {
    @Test
    void theFullPictureIsOfferedOnce() {
        assertThat(StagesAndViews.all())
                .doesNotHaveDuplicates()
                .contains(Picture.REFLECTIONS, Picture.TESTS)
                .doesNotContain(Picture.BEAUTY);
        assertThat(StagesAndViews.all().stream().map(StagesAndViews::label))
                .contains("Hard shadows", "Reflections (full picture)", "Normal");
    }

    @Test
    void stepsGoRoundAndBack() {
        assertThat(StagesAndViews.along(Picture.TESTS, 1)).isEqualTo(Picture.COLORS);
        assertThat(StagesAndViews.along(Picture.COLORS, -1)).isEqualTo(Picture.TESTS);
        assertThat(StagesAndViews.along(Picture.REFLECTIONS, 1)).isEqualTo(Picture.ALBEDO);
    }
}
