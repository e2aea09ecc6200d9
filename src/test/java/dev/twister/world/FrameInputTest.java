package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.kernel.Layout;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FrameInputTest {
    private final FrameInput whole = Worlds.world().snapshot();

    @Test
    void bandKeepsThePictureAndDrawsItsRows() {
        FrameInput band = whole.band(7, 11);
        assertThat(Arrays.copyOfRange(band.view().frame(), Layout.WIDTH, Layout.FIRST_MESH))
                .containsExactly(40, 30, 7, 11, 4);
        assertThat(band.firstRow()).isEqualTo(7);
        assertThat(band.rows()).isEqualTo(11);
        assertThat(band.height()).isEqualTo(30);
    }

    @Test
    void bandLeavesTheWholeAsItWas() {
        FrameInput band = whole.band(7, 11);
        assertThat(whole.rows()).isEqualTo(30);
        assertThat(band.bodies()).isSameAs(whole.bodies());
    }

    @ParameterizedTest
    @CsvSource({"-1, 5", "0, 0", "0, 31", "29, 2", "2147483647, 1", "0, 2147483647", "0, -1"})
    void rowsThatAreNoRowsAreRefused(int firstRow, int rows) {
        assertThatThrownBy(() -> whole.band(firstRow, rows))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageEndingWith("of 30");
    }

    @Test
    void countsComeFromTheSettings() {
        assertThat(whole.shadowSamples()).isEqualTo(5);
        assertThat(whole.bounces()).isEqualTo(6);
    }

    @Test
    void runsOfSamplesFollowEachOther() {
        FrameInput start = whole.withSamples(0, 2);
        FrameInput rest = whole.withSamples(2, 3);
        FrameInput all = whole.withSamples(0, 5);
        assertThat(all.samplesPerPixel()).isEqualTo(5);
        assertThat(samples(all))
                .startsWith(samples(start))
                .endsWith(samples(rest))
                .isEqualTo(PixelSamples.of(5));
        assertThat(camera(all)).isEqualTo(camera(whole));
    }

    private static float[] camera(FrameInput input) {
        return Arrays.copyOf(input.view().frame(), Layout.CAMERA_LENGTH);
    }

    private static float[] samples(FrameInput input) {
        float[] frame = input.view().frame();
        return Arrays.copyOfRange(frame, input.view().samplePlace(0), frame.length);
    }

    @ParameterizedTest
    @CsvSource({"-1, 5", "0, 0", "3, -1"})
    void samplesThatAreNoneAreRefused(int first, int samples) {
        assertThatThrownBy(() -> whole.withSamples(first, samples)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void anotherSizeIsTheSameView() {
        FrameInput input = SampleWorld.ofSize(40, 20).snapshot();

        FrameInput small = input.band(3, 4).withSize(10, 5);

        assertThat(small.width()).isEqualTo(10);
        assertThat(small.height()).isEqualTo(5);
        assertThat(small.firstRow()).isZero();
        assertThat(small.rows()).isEqualTo(5);
        assertThat(small.bodyCount()).isEqualTo(input.bodyCount());
        assertThat(camera(small)).isEqualTo(camera(input));
    }
}
