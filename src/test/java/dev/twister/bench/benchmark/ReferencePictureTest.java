package dev.twister.bench.benchmark;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.bench.TestWorld;
import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class ReferencePictureTest {
    private static final int WIDTH = 24;
    private static final int HEIGHT = 14;

    private final FrameInput input = input();

    @Test
    void isTheEnginesPicture() {
        ReferencePicture reference = draw(Double.POSITIVE_INFINITY);

        assertThat(reference.isWhole()).isTrue();
        assertThat(reference.frame().argb()).isEqualTo(whole());
        assertThat(reference.takesLongerThan(0)).isFalse();
        assertThat(reference.compare(new int[WIDTH * HEIGHT]).pixels()).isEqualTo(WIDTH * HEIGHT);
    }

    @Test
    void hasOneRowWhereNoTimeIsLeft() {
        ReferencePicture reference = draw(0);

        assertThat(reference.rows().cardinality()).isOne();
        assertThat(reference.takesLongerThan(0)).isTrue();
        assertThat(reference.compare(whole())).isEqualTo(new PictureComparison(WIDTH, 0, 0));
    }

    @Test
    void rowsThatWereNotRenderedDoNotCount() {
        ReferencePicture reference = draw(0);
        int row = reference.rows().nextSetBit(0);
        int[] picture = new int[WIDTH * HEIGHT];
        System.arraycopy(whole(), row * WIDTH, picture, row * WIDTH, WIDTH);

        assertThat(reference.compare(picture).differingPixels()).isZero();
        Arrays.fill(picture, row * WIDTH, (row + 1) * WIDTH, 0);
        assertThat(reference.compare(picture).differingPixels()).isEqualTo(WIDTH);
    }

    private ReferencePicture draw(double seconds) {
        try (Engine engine = Engines.open(BenchmarkPlan.REFERENCE)) {
            return ReferencePicture.draw(engine, input, seconds);
        }
    }

    private int[] whole() {
        Frame frame = Frame.ofPixels(WIDTH, HEIGHT);
        try (Engine engine = Engines.open(BenchmarkPlan.REFERENCE)) {
            engine.render(input, frame);
        }
        return frame.argb();
    }

    private static FrameInput input() {
        World world = TestWorld.create();
        world.setSettings(world.settings().withSize(WIDTH, HEIGHT));
        return world.snapshot();
    }
}
