package dev.twister.gui.picking;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.edit.Scenes;
import dev.twister.scene.Camera;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ProjectionTest {
    private final FrameInput input = Scenes.input(Scenes.scene());
    private final Projection projection = Projection.of(input);

    @Test
    void whatIsSeenAtAPlaceIsProjectedToIt() {
        PointerRay ray = PointerRay.through(input, 20, 45);

        assertThat(projection.point(ray.along(ray.distance()))).containsExactly(new double[] {20, 45}, within(1e-3));
    }

    @ParameterizedTest
    @EnumSource(Camera.Projection.class)
    void ofEveryCameraIsTheInverseOfItsRays(Camera.Projection kind) {
        Camera camera = Scenes.scene().camera().withProjection(kind).withPitchDegrees(20);
        FrameInput seen = Scenes.input(Scenes.scene().withCamera(camera.withViewHeight(4)));
        Projection inverse = Projection.of(seen);

        for (double[] pixel : new double[][] {{20, 45}, {90, 3}, {48, 32}, {5, 50}}) {
            Vector3 place = PointerRay.through(seen, pixel[0], pixel[1]).along(7);
            double perMeter = inverse.pixelsPerMeter(place);
            double[] beside = inverse.point(place.plus(inverse.right().times(1e-3)));

            assertThat(inverse.point(place)).containsExactly(pixel, within(1e-3));
            if (pixel[0] == Scenes.WIDTH / 2.0) {
                double stretched = kind == Camera.Projection.PANORAMA ? Scenes.WIDTH / 2.0 / Scenes.HEIGHT : 1;
                assertThat((beside[0] - pixel[0]) / 1e-3).isCloseTo(stretched * perMeter, within(0.01 * perMeter));
            }
        }
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
