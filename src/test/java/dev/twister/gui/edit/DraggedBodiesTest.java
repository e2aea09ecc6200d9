package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The scene has spheres 2 at (0, 2, 0) and 3 at (4, 2, 2). */
class DraggedBodiesTest {
    private final Scene scene = Scenes.scene();
    private final DraggedBodies held = new DraggedBodies(scene, SelectedBodies.of(List.of(BodyNumber.LIGHT, 3, 2)));

    @Test
    void allMoveAsFarAsTheOneThatIsHeld() {
        Scene moved = held.moved(scene, new Vector3(0.5, 2, -1));

        assertThat(BodyEdits.position(moved, 2)).isEqualTo(new Vector3(0.5, 2, -1));
        assertThat(BodyEdits.position(moved, 3)).isEqualTo(new Vector3(4.5, 2, 1));
        assertThat(BodyEdits.position(moved, BodyNumber.LIGHT)).isEqualTo(new Vector3(-3.5, 6, -1));
    }

    @Test
    void atTheEndOfTheScenesRoomTheyKeepTheirDistances() {
        Scene moved = held.moved(scene, new Vector3(SceneLimits.POSITION.max(), 2, 0));

        assertThat(BodyEdits.position(moved, 3).x()).isEqualTo(SceneLimits.POSITION.max());
        assertThat(BodyEdits.position(moved, 2).x()).isEqualTo(SceneLimits.POSITION.max() - 4);
    }
}
