package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.panel.OutlineLine;
import dev.twister.kernel.Layout;
import dev.twister.scene.Light;
import dev.twister.scene.Scene;
import dev.twister.scene.light.Lights;
import dev.twister.scene.select.Tag;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class TagEditsTest {
    private static final int FIRST = Layout.FIRST_SPHERE;
    private static final Scene SCENE = Scenes.scene();

    @Test
    void theLastVisibleLightStays() {
        assertThat(TagEdits.hideable(SCENE, List.of(BodyNumber.LIGHT, FIRST))).containsExactly(FIRST);
        Scene two = SCENE.withLights(new Lights(List.of(Light.DEFAULT, Light.DEFAULT)));
        assertThat(TagEdits.hideable(two, List.of(BodyNumber.LIGHT))).containsExactly(BodyNumber.LIGHT);
        Scene one = TagEdits.edited(two, List.of(BodyNumber.LIGHT), tag -> tag.withHidden(true));
        assertThat(TagEdits.hideable(one, List.of(BodyNumber.ofLight(1)))).isEmpty();
    }

    @Test
    void aLockedBodyIsNeitherMovedNorDeletedWithOthers() {
        Scene locked = TagEdits.edited(SCENE, List.of(FIRST), tag -> tag.withLocked(true));
        SelectedBodies both = SelectedBodies.of(List.of(FIRST + 1, FIRST));
        assertThat(BodyEdits.deletable(locked, both).bodies()).containsExactly(FIRST + 1);
        assertThat(BodyTransform.of(locked, both).orElseThrow().bodies()).containsExactly(FIRST + 1);
        assertThat(BodyEdits.movable(locked)).doesNotContain(FIRST);
    }

    @Test
    void aNewGroupHasANameOfItsOwn() {
        Scene grouped = TagEdits.edited(SCENE, List.of(FIRST), tag -> tag.withGroup("Group 1"));
        assertThat(TagEdits.newGroup(grouped)).isEqualTo("Group 2");
        assertThat(TagEdits.members(grouped, "Group 1")).containsExactly(FIRST);
    }

    @Test
    void groupsAreListedAfterTheOthersUnlessFolded() {
        Scene grouped = TagEdits.edited(SCENE, List.of(FIRST), tag -> new Tag("Ball", "Toys", false, false));
        assertThat(OutlineLine.of(grouped, SelectedBodies.NONE, Set.of()))
                .extracting(OutlineLine::text)
                .containsExactly("Light", "Plane", "Sphere 2", "Toys", "Ball");
        assertThat(OutlineLine.of(grouped, SelectedBodies.NONE, Set.of("Toys")))
                .extracting(OutlineLine::text)
                .containsExactly("Light", "Plane", "Sphere 2", "Toys");
    }
}
