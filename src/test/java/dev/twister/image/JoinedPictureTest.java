package dev.twister.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrReader.ExrExtent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class JoinedPictureTest {
    /** 3 samples of 1 and 9 of 5 are 12 samples of 4. */
    @Test
    void pixelsAreWeightedByTheirSamples() {
        ExrPicture first = part("0-15", 1, 3);
        ExrPicture second = part("16-31", 5, 9);
        ExrExtent extent = new ExrExtent(2, 1, 0, 1);
        JoinedPicture joined = new JoinedPicture(Path.of("first.exr"), first, List.of(extent, extent));
        joined.add(Path.of("first.exr"), first);
        joined.add(Path.of("second.exr"), second);
        ExrPicture whole = joined.whole();

        assertThat(values(whole, "R")).containsExactly(4, 4);
        assertThat(values(whole, JoinedPicture.SAMPLES)).containsExactly(12, 12);
    }

    @ParameterizedTest
    @ValueSource(floats = {0, -1, Float.NaN, Float.POSITIVE_INFINITY})
    void pixelsWithoutSamplesAreRefused(float samples) {
        ExrPicture part = part("0-15", 1, samples);
        JoinedPicture joined = new JoinedPicture(Path.of("a.exr"), part, List.of(new ExrExtent(2, 1, 0, 1)));

        assertThatIllegalArgumentException()
                .isThrownBy(() -> joined.add(Path.of("a.exr"), part))
                .withMessage("a.exr has a pixel of " + samples + " samples in the layer samples.Y; expected 1 or more");
    }

    @Test
    void theDisplaySettingsStay() {
        Optional<DisplaySettings> display = Optional.of(new DisplaySettings(1.5, "aces", false));
        ExrPicture plain = part("0-15", 1, 1);
        ExrPicture part =
                new ExrPicture(2, 1, 0, 1, plain.channels(), plain.provenance().map(made -> made.withDisplay(display)));
        JoinedPicture joined = new JoinedPicture(Path.of("a.exr"), part, List.of(new ExrExtent(2, 1, 0, 1)));
        joined.add(Path.of("a.exr"), part);

        assertThat(joined.whole().provenance().orElseThrow().display()).isEqualTo(display);
    }

    private static float[] values(ExrPicture picture, String name) {
        return picture.channels().stream()
                .filter(channel -> channel.name().equals(name))
                .findFirst()
                .orElseThrow()
                .values();
    }

    private static ExrPicture part(String range, float value, float samples) {
        return new ExrPicture(
                2,
                1,
                0,
                1,
                List.of(
                        new ExrChannel("R", new float[] {value, value}, 0, 1),
                        new ExrChannel(JoinedPicture.SAMPLES, new float[] {samples, samples}, 0, 1)),
                Optional.of(new Provenance("Twister", "picture", range)));
    }
}
