package dev.twister.gui.model;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.world.Picture;
import org.junit.jupiter.api.Test;

class ShownPicturesTest {
    @Test
    void theFullPictureIsOfferedOnce() {
        assertThat(ShownPictures.all())
                .doesNotHaveDuplicates()
                .contains(Picture.REFLECTIONS, Picture.TESTS)
                .doesNotContain(Picture.BEAUTY);
        assertThat(ShownPictures.all().stream().map(ShownPictures::label))
                .contains("Hard shadows", "Reflections (full picture)", "Normal");
    }

    @Test
    void stepsGoRoundAndBack() {
        assertThat(ShownPictures.along(Picture.TESTS, 1)).isEqualTo(Picture.COLORS);
        assertThat(ShownPictures.along(Picture.COLORS, -1)).isEqualTo(Picture.TESTS);
        assertThat(ShownPictures.along(Picture.REFLECTIONS, 1)).isEqualTo(Picture.ALBEDO);
    }
}
