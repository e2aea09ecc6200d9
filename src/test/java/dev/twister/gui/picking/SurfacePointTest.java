package dev.twister.gui.picking;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.edit.Scenes;
import dev.twister.gui.picking.SurfacePoint.RestingBody;
import dev.twister.kernel.Layout;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.List;
import org.junit.jupiter.api.Test;

class SurfacePointTest {
    private static final double MIDDLE = Scenes.WIDTH / 2.0;
    private final FrameInput input = Scenes.input(Scenes.scene());

    @Test
    void aSphereIsMetWhereItIsSeen() {
        SurfacePoint point = SurfacePoint.under(input, MIDDLE, Scenes.HEIGHT / 2.0, _ -> false)
                .orElseThrow();

        assertThat(point.place().minus(new Vector3(0, 2, -1.5)).length()).isCloseTo(0, within(1e-4));
        assertThat(point.normal().minus(new Vector3(0, 0, -1)).length()).isCloseTo(0, within(1e-4));
    }

    @Test
    void aBodyThatIsPassedIsSeenThrough() {
        double lower = Scenes.HEIGHT / 2.0 + 5;
        SurfacePoint ground = SurfacePoint.under(input, MIDDLE, lower, body -> body == Layout.FIRST_SPHERE)
                .orElseThrow();

        assertThat(ground.place().y()).isCloseTo(0, within(1e-4));
        assertThat(ground.normal()).isEqualTo(new Vector3(0, 1, 0));
        assertThat(SurfacePoint.under(input, MIDDLE, Scenes.HEIGHT / 2.0, _ -> true))
                .isEmpty();
    }

    @Test
    void aSphereTouchesTheSurfaceAndABoxStandsOnIt() {
        SurfacePoint ground = new SurfacePoint(new Vector3(3, 0, 1), new Vector3(0, 1, 0));
        List<Vector3> corners = List.of(new Vector3(-1, -2, -1), new Vector3(1, 4, 1));

        assertThat(new RestingBody(0.5, List.of()).on(ground)).isEqualTo(new Vector3(3, 0.5, 1));
        assertThat(new RestingBody(0, corners).on(ground)).isEqualTo(new Vector3(3, 2, 1));
    }
}
