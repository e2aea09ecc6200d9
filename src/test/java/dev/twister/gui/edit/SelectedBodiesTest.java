package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class SelectedBodiesTest {
    private final SelectedBodies three = SelectedBodies.of(List.of(2, 5, 3));

    @Test
    void theBodySelectedLastIsActive() {
        assertThat(three.active()).isEqualTo(3);
        assertThat(three.toggled(9).active()).isEqualTo(9);
    }

    @Test
    void withoutTheActiveBodyTheLastOneOfTheOthersIs() {
        assertThat(three.toggled(3)).isEqualTo(SelectedBodies.of(List.of(2, 5)));
        assertThat(three.toggled(2).active()).isEqualTo(3);
        assertThat(SelectedBodies.of(2).toggled(2)).isEqualTo(SelectedBodies.NONE);
    }

    @Test
    void theActiveBodyStaysItWhereItIsKept() {
        SelectedBodies active = three.withActive(5);

        assertThat(active.where(body -> body > 2)).isEqualTo(SelectedBodies.of(List.of(3, 5)));
        assertThat(active.where(body -> body != 5)).isEqualTo(SelectedBodies.of(List.of(2, 3)));
    }
}
