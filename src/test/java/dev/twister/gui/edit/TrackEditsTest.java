package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.edit.TrackEdits.KeyMark;
import dev.twister.scene.Easing;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class TrackEditsTest {
    private static final TrackTarget BALL = TrackTarget.sphere(1);
    private static final Scene SCENE = Scenes.scene()
            .withTracks(List.of(
                    Track.of(BALL, "radius", Keyframe.of(1, 0.5), Keyframe.of(2, 1), Keyframe.of(4, 2)),
                    Track.of(TrackTarget.light(0), "share", Keyframe.of(2, 1))));

    @Test
    void aKeyframeHasThePresentValueAndReplacesOneAtItsTime() {
        Scene moved = BodyEdits.moved(SCENE, BodyNumber.ofSphere(1), new Vector3(1, 2, 3));
        Scene once = TrackEdits.set(moved, BALL, "position", 1.004);
        Scene twice = TrackEdits.set(
                BodyEdits.moved(once, BodyNumber.ofSphere(1), new Vector3(4, 5, 6)), BALL, "position", 1);

        assertThat(once.tracks().getLast()).isEqualTo(Track.of(BALL, "position", Keyframe.of(1, new Vector3(1, 2, 3))));
        assertThat(twice.tracks().getLast())
                .isEqualTo(Track.of(BALL, "position", Keyframe.of(1, new Vector3(4, 5, 6))));
    }

    @Test
    void aNewKeyframeIsEasedAsTheOneBeforeIt() {
        Scene held = TrackEdits.eased(SCENE, Set.of(new KeyMark(BALL, 2)), Easing.HOLD);

        assertThat(TrackEdits.set(held, BALL, "radius", 3).tracks().getFirst().keyframes())
                .extracting(Keyframe::easing)
                .containsExactly(Easing.SMOOTH, Easing.HOLD, Easing.HOLD, Easing.SMOOTH);
    }

    @Test
    void whatTheTargetLacksGetsNoKeyframe() {
        assertThat(TrackEdits.set(SCENE, BALL, "share", 1)).isEqualTo(SCENE);
    }

    @Test
    void movedKeyframesReplaceThoseThatTheyMeet() {
        Scene moved = TrackEdits.moved(SCENE, Set.of(new KeyMark(BALL, 1)), 1);

        assertThat(TrackEdits.times(moved, BALL)).containsExactly(2.0, 4.0);
        assertThat(moved.tracks().getFirst().keyframes().getFirst()).isEqualTo(Keyframe.of(2, 0.5));
        assertThat(TrackEdits.times(moved, TrackTarget.light(0))).containsExactly(2.0);
    }

    @Test
    void keyframesMoveTogetherAndNotBeforeTheBeginning() {
        Set<KeyMark> marks = Set.of(new KeyMark(BALL, 1), new KeyMark(BALL, 4));

        assertThat(TrackEdits.times(TrackEdits.moved(SCENE, marks, -3), BALL)).containsExactly(0.0, 2.0, 3.0);
        assertThat(TrackEdits.movedMarks(marks, -3))
                .containsExactlyInAnyOrder(new KeyMark(BALL, 0), new KeyMark(BALL, 3));
    }

    @Test
    void copiesBeginAtATime() {
        Set<KeyMark> marks = Set.of(new KeyMark(BALL, 1), new KeyMark(BALL, 2));

        assertThat(TrackEdits.times(TrackEdits.copied(SCENE, marks, 5), BALL)).containsExactly(1.0, 2.0, 4.0, 5.0, 6.0);
    }

    @Test
    void aTrackWithoutKeyframesGoes() {
        assertThat(TrackEdits.deleted(SCENE, Set.of(new KeyMark(TrackTarget.light(0), 2)))
                        .tracks())
                .containsExactly(SCENE.tracks().getFirst());
    }

    @Test
    void theCamerasPathIsARowOfItsOwn() {
        Scene path = KeyframeEdits.set(SCENE, 3);

        assertThat(TrackEdits.targets(path)).containsExactly(TrackTarget.CAMERA, BALL, TrackTarget.light(0));
        assertThat(TrackEdits.times(
                        TrackEdits.moved(path, Set.of(new KeyMark(TrackTarget.CAMERA, 3)), 1), TrackTarget.CAMERA))
                .containsExactly(4.0);
    }

    @Test
    void tracksFollowTheirBodiesWhenOthersAreDeleted() {
        assertThat(BodyEdits.deleted(SCENE, BodyNumber.ofSphere(0))
                        .tracks()
                        .getFirst()
                        .target())
                .isEqualTo(TrackTarget.sphere(0));
        assertThat(BodyEdits.deleted(SCENE, BodyNumber.ofSphere(1)).tracks())
                .containsExactly(SCENE.tracks().getLast());
    }
}
