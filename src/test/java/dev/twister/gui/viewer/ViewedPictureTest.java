package dev.twister.gui.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import dev.twister.image.ExrPicture;
import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrWriter;
import dev.twister.image.HdrWriter;
import dev.twister.image.Provenance;
import dev.twister.scene.Rgb;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ViewedPictureTest {
    private static final Provenance MADE = new Provenance("Twister", "picture", "4");

    @TempDir
    private Path folder;

    @Test
    void itsLightsAreMultipliedByTheirFactors() throws IOException {
        ViewedPicture picture = ViewedPicture.read(exr(0, Map.of("", 5f, "light-lamp.", 2f, "light-sky.", 3f)));

        assertThat(picture.lights()).extracting(ViewedPicture.Light::group).containsExactly("lamp", "sky");
        Rgb white = new Rgb(1, 1, 1);
        assertThat(picture.lit(List.of(white, white))).containsOnly(5);
        assertThat(picture.lit(List.of(new Rgb(0.5, 0.5, 0.5), new Rgb(2, 2, 2))))
                .containsOnly(7);
        float[] red = picture.lit(List.of(new Rgb(1, 0, 0), new Rgb(0, 0, 0)));
        assertThat(Arrays.copyOf(red, 6)).containsExactly(2, 0, 0, 2, 0, 0);
    }

    @Test
    void aDenoisedFileHasItsNoisyPictureToo() throws IOException {
        ViewedPicture picture = ViewedPicture.read(exr(0, Map.of("", 5f, "noisy.", 4f, "light-lamp.", 2f)));

        assertThat(picture.radiance()).containsOnly(4);
        assertThat(picture.clean(List.of(new Rgb(1, 1, 1))).orElseThrow()).containsOnly(5);
        assertThat(picture.clean(List.of(new Rgb(2, 1, 1)))).isEmpty();
    }

    @Test
    void otherFilesHaveNoLights() throws IOException {
        Path file = folder.resolve("a.hdr");
        HdrWriter.write(file, 2, 1, new float[] {1, 2, 4, 0.5f, 0.5f, 0.5f}, new Provenance("Twister", "picture", "1"));
        ViewedPicture picture = ViewedPicture.read(file);

        assertThat(picture.lights()).isEmpty();
        assertThat(picture.radiance()[picture.at(1, 0, 2)]).isEqualTo(0.5f);
        assertThat(picture.lit(List.of())).isEqualTo(picture.radiance());
    }

    @Test
    void aPartIsNoPicture() throws IOException {
        Path part = exr(1, Map.of("", 1f));

        assertThatIOException()
                .isThrownBy(() -> ViewedPicture.read(part))
                .withMessage(part + " is a part of a picture; 'twister join' makes a picture of parts");
    }

    @Test
    void namesTheFirstOfSeveralParts() throws IOException {
        Path file = Path.of("src", "test", "resources", "exr", "zip-parts.exr");

        assertThat(ViewedPicture.read(file).part()).contains("the first of 3 parts, 'part0'");
    }

    @Test
    void readsLayersOfOtherPrograms() throws IOException {
        Path file = folder.resolve("blender.exr");
        List<ExrChannel> channels = new ArrayList<>();
        for (String layer : List.of("ViewLayer.AO.", "ViewLayer.Combined.")) {
            for (String channel : List.of("R", "G", "B")) {
                float value = layer.endsWith("AO.") ? 1 : 3;
                channels.add(new ExrChannel(layer + channel, new float[] {value}, 0, 1));
            }
        }
        ExrWriter.write(file, 1, 1, channels);

        assertThat(ViewedPicture.read(file).radiance()).containsExactly(3, 3, 3);
    }

    @Test
    void numbersAreNoPicture() throws IOException {
        Path numbers = exr(0, Map.of("depth.", 1f));

        assertThatIOException()
                .isThrownBy(() -> ViewedPicture.read(numbers))
                .withMessage(numbers + " has no colors, only numbers");
    }

    private Path exr(int firstRow, Map<String, Float> layers) throws IOException {
        Path file = folder.resolve("a.exr");
        List<ExrChannel> channels = new ArrayList<>();
        layers.forEach((layer, value) -> {
            for (String channel : List.of("R", "G", "B")) {
                float[] values = new float[2 * (3 - firstRow)];
                Arrays.fill(values, value);
                channels.add(new ExrChannel(layer + channel, values, 0, 1));
            }
        });
        ExrWriter.write(file, new ExrPicture(2, 3, firstRow, 3 - firstRow, channels, Optional.of(MADE)));
        return file;
    }
}
