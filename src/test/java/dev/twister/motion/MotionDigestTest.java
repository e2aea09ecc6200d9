package dev.twister.motion;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.physics.Simulation;
import dev.twister.scene.FullScene;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneChanges;
import dev.twister.scene.TrackTarget;
import dev.twister.world.SceneMeshes;
import java.util.Arrays;
import java.util.SequencedMap;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class MotionDigestTest {
    private static final SequencedMap<String, Scene> CHANGES = SceneChanges.of(FullScene.SCENE);
    private static final float[] END = end(FullScene.SCENE);

    static Set<String> places() {
        return CHANGES.keySet();
    }

    @ParameterizedTest
    @MethodSource("places")
    void changesWithWhatChangesTheMotion(String place) {
        Scene changed = CHANGES.get(place);

        boolean sameDigest = Arrays.equals(MotionDigest.of(changed), MotionDigest.of(FullScene.SCENE));

        // Only those of the same digest need be simulated.
        assertThat(!sameDigest || Arrays.equals(end(changed), END)).isTrue();
    }

    @Test
    void staysWhereOnlyTheSightChanges() {
        byte[] digest = MotionDigest.of(FullScene.SCENE);

        assertThat(CHANGES.entrySet())
                .filteredOn(change -> change.getKey()
                        .matches("(title|camera|views|sky|shading|rendering|materials|tracks|.*strength|.*share).*"))
                .filteredOn(change -> change.getValue().tracks().stream()
                        .noneMatch(track -> track.target().kind() == TrackTarget.Kind.MESH))
                .isNotEmpty()
                .allSatisfy(
                        change -> assertThat(MotionDigest.of(change.getValue())).isEqualTo(digest));
    }

    private static float[] end(Scene scene) {
        try (Simulation simulation = Simulation.ofFilm(scene, SceneMeshes.of(scene, FullScene.MESHES), 0)) {
            simulation.advance(1);
            return simulation.positions();
        }
    }
}
