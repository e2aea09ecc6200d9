package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Easing;
import dev.twister.scene.FullScene;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Rgb;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.TrackProperties;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class AnimationTest {
    private static final Scene SCENE = FullScene.SCENE.withTracks(List.of());
    private static final Track RISING =
            Track.of(TrackTarget.RENDERING, "exposure", Keyframe.of(1, 0), Keyframe.of(3, 4), Keyframe.of(4, 2));

    @Test
    void valuesRestBeforeTheFirstAndAfterTheLastKeyframe() {
        assertThat(exposure(RISING, 0)).isZero();
        assertThat(exposure(RISING, 9)).isEqualTo(2);
    }

    @ParameterizedTest
    @EnumSource(Easing.class)
    void everyKeyframeIsMet(Easing easing) {
        Track track = eased(RISING, easing);

        assertThat(track.keyframes())
                .allSatisfy(key -> assertThat(exposure(track, key.seconds()))
                        .isEqualTo(key.value().getFirst()));
    }

    @Test
    void linearIsHalfwayAtHalfTheTime() {
        assertThat(exposure(eased(RISING, Easing.LINEAR), 2)).isEqualTo(2);
    }

    @Test
    void heldValuesJumpAtTheNextKeyframe() {
        assertThat(exposure(eased(RISING, Easing.HOLD), 2.999)).isZero();
        assertThat(exposure(eased(RISING, Easing.HOLD), 3)).isEqualTo(4);
    }

    @Test
    void smoothStartsAndEndsAtRestAndStaysBetweenTheKeyframes() {
        assertThat(exposure(RISING, 1.001)).isCloseTo(0, within(1e-5));
        assertThat(exposure(RISING, 2)).isCloseTo(2, within(1e-12));
        assertThat(IntStream.rangeClosed(0, 400).mapToDouble(i -> exposure(RISING, i / 100.0)))
                .allSatisfy(value -> assertThat(value).isBetween(0.0, 4.0));
    }

    @Test
    void aLoopBeginsAgain() {
        Track loop = eased(RISING, Easing.LINEAR).withLoop(true);

        assertThat(exposure(loop, 2 + 3)).isEqualTo(2);
        assertThat(exposure(loop, 3.5 - 3)).isCloseTo(3, within(1e-12));
    }

    @Test
    void aLoopThatGoesOnTurnsSteadily() {
        Track turn = Track.of(TrackTarget.SKY, "rotation", Keyframe.of(0, 0), Keyframe.of(4, 360))
                .withLoop(true);

        assertThat(Animation.at(with(turn), 1).sky().rotationDegrees()).isCloseTo(90, within(1e-9));
    }

    @Test
    void movesBodiesLightsAndTheRest() {
        Scene now = Animation.at(
                SCENE.withTracks(List.of(
                        Track.of(TrackTarget.sphere(1), "position", Keyframe.of(0, new Vector3(1, 2, 3))),
                        Track.of(TrackTarget.sphere(1), "roughness", Keyframe.of(0, 0.5)),
                        Track.of(TrackTarget.mesh(0), "rotation", Keyframe.of(0, new Vector3(10, 20, 30))),
                        Track.of(TrackTarget.light(1), "color", Keyframe.of(0, new Rgb(4, 5, 6))),
                        Track.of(TrackTarget.CAMERA, "focusDistance", Keyframe.of(0, 3)))),
                7);

        assertThat(now.spheres().get(1).position()).isEqualTo(new Vector3(1, 2, 3));
        assertThat(now.spheres().get(1).material().roughness()).isEqualTo(0.5);
        assertThat(now.spheres().getFirst()).isEqualTo(SCENE.spheres().getFirst());
        // Yaw, pitch and roll, as in files.
        assertThat(now.meshes().getFirst().rotation()).isEqualTo(new Rotation(10, 20, 30));
        assertThat(now.lights().get(1).color()).isEqualTo(new Rgb(4, 5, 6));
        assertThat(now.camera().focusDistance()).isEqualTo(3);
    }

    @Test
    void everyPropertyIsWrittenAsItWasRead() {
        List<TrackTarget> targets = List.of(
                TrackTarget.CAMERA,
                TrackTarget.light(0),
                TrackTarget.PLANE,
                TrackTarget.sphere(1),
                TrackTarget.mesh(0),
                TrackTarget.SKY,
                TrackTarget.SHADING,
                TrackTarget.RENDERING);

        assertThat(targets)
                .allSatisfy(target -> assertThat(TrackProperties.of(target)).allSatisfy(property -> {
                    assertThat(property.withNumbers(SCENE, property.numbers(SCENE)))
                            .isEqualTo(SCENE);
                    assertThat(property.numbers(SCENE)).hasSize(property.count());
                }));
    }

    @Test
    void whatHasNoTracksStaysTheSame() {
        Scene now = Animation.at(with(RISING), 2);

        assertThat(now.spheres()).isSameAs(SCENE.spheres());
        assertThat(now.lights()).isSameAs(SCENE.lights());
    }

    @Test
    void endsWithTheLastKeyframeOfAll() {
        Camera camera = SCENE.camera();

        assertThat(Animation.length(with(RISING), SceneMeshes.NONE)).isEqualTo(4);
        assertThat(Animation.length(
                        with(RISING).withCamera(camera.withKeyframes(List.of(CameraKeyframe.of(5, camera)))),
                        SceneMeshes.NONE))
                .isEqualTo(5);
    }

    @Test
    void aFilmThatLoopsDoesNotShowItsFirstPictureTwice() {
        Track turning = Track.of(
                        TrackTarget.sphere(0),
                        "position",
                        Keyframe.of(0, new Vector3(-2, 0, 0)),
                        Keyframe.of(0.5, new Vector3(2, 0, 0)))
                .withLoop(true);
        Track thrice = RISING.withLoop(true)
                .withKeyframes(List.of(
                        RISING.keyframes().getFirst().withSeconds(0),
                        RISING.keyframes().getLast().withSeconds(0.1)));
        Track rising = RISING.withKeyframes(List.of(
                RISING.keyframes().getFirst().withSeconds(0),
                RISING.keyframes().getLast().withSeconds(0.5)));

        assertThat(framesOfTracks(10, turning)).isEqualTo(5);
        assertThat(framesOfTracks(25, turning)).isEqualTo(13);
        assertThat(framesOfTracks(60, turning, thrice)).isEqualTo(30);
        assertThat(framesOfTracks(10, turning.withLoop(false))).isEqualTo(6);
        assertThat(framesOfTracks(10, turning, rising)).isEqualTo(6);
    }

    private static int framesOfTracks(double rate, Track... tracks) {
        return Animation.frames(
                SCENE.withCamera(SCENE.camera().withKeyframes(List.of())).withTracks(List.of(tracks)),
                SceneMeshes.NONE,
                rate);
    }

    private static Scene with(Track track) {
        return SCENE.withTracks(List.of(track));
    }

    private static double exposure(Track track, double seconds) {
        return Animation.at(with(track), seconds).rendering().exposure();
    }

    private static Track eased(Track track, Easing easing) {
        return track.withKeyframes(track.keyframes().stream()
                .map(keyframe -> keyframe.withEasing(easing))
                .toList());
    }
}
