package dev.twister.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.kernel.Layout;
import dev.twister.render.ShutterEngine.Moment;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import dev.twister.world.TonedPixels;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShutterEngineTest {
    private static final int WIDTH = 40;
    private static final int HEIGHT = 20;

    /** The largest difference between a share of the samples and the share of the time in which they are. */
    @ParameterizedTest
    @CsvSource({
        "1, 2, 0.4",
        "1, 4, 0.25",
        "1, 8, 0.15",
        "9, 8, 0.15",
        "1, 16, 0.08",
        "0, 33, 0.06",
        "64, 64, 0.05",
        "1, 64, 0.03",
        "1, 256, 0.02",
        "257, 256, 0.06",
        "1, 1000, 0.025",
        "1, 65536, 0.02"
    })
    void samplesFillTheShutterEvenly(int first, int samples, double most) {
        double[] parts = IntStream.range(first, first + samples)
                .mapToDouble(sample -> Moment.of(sample).part())
                .sorted()
                .toArray();

        for (int i = 0; i < samples; i++) {
            assertThat(parts[i]).isBetween((i + 1.0) / samples - most, (double) i / samples + most);
        }
    }

    @Test
    void twiceTheSamplesHaveAsManyMomentsMore() {
        assertThat(moments(64)).isEqualTo(64);
        assertThat(moments(128)).isEqualTo(96);
        assertThat(moments(4096)).isEqualTo(256);
        for (int sample = 0; sample < 3000; sample++) {
            assertThat(Moment.of(sample).end()).isGreaterThan(sample);
            assertThat(Moment.of(Moment.of(sample).end() - 1)).isEqualTo(Moment.of(sample));
        }
    }

    private static long moments(int samples) {
        return IntStream.range(0, samples)
                .mapToDouble(sample -> Moment.of(sample).part())
                .distinct()
                .count();
    }

    @Test
    void aPictureIsTheMeanOfItsMoments() {
        FrameInput whole = at(1).withSamples(1, 5).withGuides();
        boolean[] wanted = new boolean[3];
        wanted[1] = true;
        FrameInput input = whole.band(0, 16).withTiles(wanted);
        Frame blurred = Frame.ofRadiance(WIDTH, 16, input.layers());
        Frame expected = Frame.ofRadiance(WIDTH, 16, input.layers());
        List<Integer> drawn = new ArrayList<>();
        try (Engine engine = Engines.open("sequential")) {
            new ShutterEngine(engine, part -> at(part).withGuides(), drawn::add).render(input, blurred);
            for (int sample = 1; sample <= 5; sample++) {
                Frame moment = Frame.ofRadiance(WIDTH, 16, input.layers());
                engine.render(
                        at(Moment.of(sample).part()).withGuides().band(0, 16).withSamples(sample, 1), moment);
                add(moment.radiance(), expected.radiance());
                add(moment.layers(), expected.layers());
            }
        }

        assertThat(drawn).containsExactly(1, 2, 3, 4, 5);
        assertThat(column(blurred.radiance(), 20)).containsExactly(column(expected.radiance(), 20), within(1e-5f));
        assertThat(column(blurred.layers(), 20)).containsExactly(column(expected.layers(), 20), within(1e-5f));
        assertThat(DoubleStream.of(0, 1).mapToObj(part -> at(part).bodies().center(Layout.FIRST_SPHERE, 0)))
                .doesNotHaveDuplicates();
    }

    /** The values of a column of pixels, which is in the tile that is rendered. */
    private static float[] column(float[] values, int column) {
        float[] picked = new float[values.length / WIDTH];
        for (int i = 0; i < picked.length; i++) {
            picked[i] = values[i / 3 * 3 * WIDTH + 3 * column + i % 3];
        }
        return picked;
    }

    private static void add(float[] from, float[] to) {
        for (int i = 0; i < from.length; i++) {
            to[i] += from[i] / 5;
        }
    }

    @Test
    void pixelsAreTonedAfterTheMean() {
        FrameInput input = at(1).withSamples(1, 6);
        Frame linear = Frame.ofRadiance(WIDTH, HEIGHT);
        Frame pixels = Frame.ofPixels(WIDTH, HEIGHT);
        try (Engine engine = Engines.open("sequential")) {
            ShutterEngine shutter = new ShutterEngine(engine, ShutterEngineTest::at, _ -> {});
            shutter.render(input, linear);
            shutter.render(input, pixels);
        }
        int[] expected = new int[WIDTH * HEIGHT];
        TonedPixels.write(linear.radiance(), input, expected);

        assertThat(pixels.argb()).isEqualTo(expected);
        assertThat(Arrays.stream(expected).distinct().count()).isGreaterThan(20);
    }

    /** Five spheres that move to the right. */
    private static FrameInput at(double part) {
        World world = SampleWorld.ofSize(WIDTH, HEIGHT);
        world.show(world.scene()
                .withSpheres(world.scene().spheres().stream()
                        .map(sphere -> sphere.withPosition(sphere.position().plus(new Vector3(3 * part, 0, 0))))
                        .toList()));
        return world.snapshot();
    }
}
