package dev.twister.gui.picking;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.edit.Scenes;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import org.junit.jupiter.api.Test;

class ProjectionTest {
    private final FrameInput input = Scenes.input(Scenes.scene());
    private final Projection projection = Projection.of(input);

    @Test
    void whatIsSeenAtAPlaceIsProjectedToIt() {
        PointerRay ray = PointerRay.through(input, 20, 45);

        assertThat(projection.point(ray.along(ray.distance()))).containsExactly(new double[] {20, 45}, within(1e-3));
    }

    @Test
    void aLineEndsWhereItGoesBehindTheCamera() {
        Vector3 ahead = new Vector3(1, 2, 0);
        Vector3 behind = new Vector3(1, 2, -20);

        double[] line = projection.line(ahead, behind);

        assertThat(projection.point(behind)).isEmpty();
        assertThat(projection.line(behind, new Vector3(0, 0, -30))).isEmpty();
        assertThat(new double[] {line[0], line[1]}).containsExactly(projection.point(ahead), within(1e-9));
        assertThat(line[2]).isGreaterThan(Scenes.WIDTH);
        assertThat(line[3]).isCloseTo(Scenes.HEIGHT / 2.0, within(1e-6));
    }
}
