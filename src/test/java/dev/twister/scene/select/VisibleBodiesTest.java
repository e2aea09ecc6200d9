package dev.twister.scene.select;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Keyframe;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What is left of a scene in pictures. */
class VisibleBodiesTest {
    private static final Tag HIDDEN = Tag.NONE.withHidden(true);
    private static final Sphere LEFT = Sphere.DEFAULT.withPosition(new Vector3(-1, 0, 0));
    private static final Sphere RIGHT = Sphere.DEFAULT.withPosition(new Vector3(1, 0, 0));
    private static final Scene SCENE = Scene.under(Path.of("none.hdr"));

    @Test
    void aSceneWithoutTagsIsItsVisiblePart() {
        Scene scene = SCENE.withSpheres(List.of(LEFT, RIGHT));
        assertThat(VisibleBodies.of(scene)).isSameAs(scene);
    }

    @Test
    void hiddenBodiesAndLightsAreLeftOut() {
        Light lamp = Light.DEFAULT.withRadius(2);
        Mesh knot = Mesh.of(Path.of("knot.obj"));
        Scene scene = SCENE.withSpheres(List.of(LEFT.withTag(HIDDEN), RIGHT))
                .withMeshes(List.of(knot.withTag(HIDDEN)))
                .withLights(new Lights(List.of(Light.DEFAULT.withTag(HIDDEN), lamp)));
        assertThat(VisibleBodies.of(scene))
                .isEqualTo(SCENE.withSpheres(List.of(RIGHT)).withLights(Lights.of(lamp)));
    }

    @Test
    void namesAndGroupsChangeNoPicture() {
        Scene scene = SCENE.withSpheres(List.of(LEFT, RIGHT.withTag(new Tag("Ball", "Toys", false, true))));
        assertThat(VisibleBodies.of(scene)).isEqualTo(SCENE.withSpheres(List.of(LEFT, RIGHT)));
    }

    @Test
    void tracksFollowTheirBodies() {
        Track ofLeft = Track.of(TrackTarget.sphere(0), "radius", Keyframe.of(1, 2));
        Track ofRight = Track.of(TrackTarget.sphere(1), "radius", Keyframe.of(1, 3));
        Scene scene = SCENE.withSpheres(List.of(LEFT.withTag(HIDDEN), RIGHT)).withTracks(List.of(ofLeft, ofRight));
        assertThat(VisibleBodies.of(scene).tracks()).containsExactly(ofRight.withTarget(TrackTarget.sphere(0)));
    }
}
