package dev.twister.gui.rendering;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.edit.Scenes;
import dev.twister.gui.rendering.WindowOrder.FilmMotion;
import dev.twister.gui.rendering.WindowOrder.FilmPlan;
import dev.twister.render.FrameRange;
import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import java.util.List;
import org.junit.jupiter.api.Test;

class FilmMotionTest {
    private static final Scene FALLING = Scenes.scene();
    private static final Scene EMPTY = FALLING.withSpheres(List.of());

    @Test
    void offersWhatTheSceneHas() {
        assertThat(FilmMotion.of(EMPTY)).isEmpty();
        assertThat(FilmMotion.of(FALLING)).containsExactly(FilmMotion.PHYSICS);
        assertThat(FilmMotion.of(withPath(EMPTY, 2))).containsExactly(FilmMotion.KEYFRAMES);
        assertThat(FilmMotion.of(withPath(FALLING, 2))).containsExactly(FilmMotion.values());
    }

    @Test
    void oneKeyframeIsNoPath() {
        assertThat(FilmMotion.of(withPath(EMPTY, 1))).isEmpty();
    }

    @Test
    void withoutGravityNothingFalls() {
        Scene weightless = FALLING.withPhysics(FALLING.physics().withGravity(new Vector3(0, 0, 0)));

        assertThat(FilmMotion.of(weightless)).isEmpty();
    }

    @Test
    void theCameraFollowsItsKeyframesWhereItMoves() {
        Camera camera = withPath(EMPTY, 2).camera();

        assertThat(camera(FilmMotion.KEYFRAMES, camera, 1).position().x()).isEqualTo(5);
        assertThat(camera(FilmMotion.PHYSICS, camera, 1)).isEqualTo(camera);
    }

    private static Scene withPath(Scene scene, int keyframes) {
        Camera camera = scene.camera();
        List<CameraKeyframe> keys = List.of(
                CameraKeyframe.of(0, camera), CameraKeyframe.of(1, camera.withPosition(new Vector3(5, 2, -10))));
        return scene.withCamera(camera.withKeyframes(keys.subList(0, keyframes)));
    }

    private static Camera camera(FilmMotion motion, Camera from, double seconds) {
        return new FilmPlan(motion, 30, FrameRange.ofCount(1))
                .movement(EMPTY.withCamera(from))
                .scene()
                .apply(seconds)
                .camera();
    }
}
