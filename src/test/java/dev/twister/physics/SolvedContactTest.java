package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SolvedContactTest {
    private final double[] impulses = {9, 9, 9, 9, 1, 2, 3, 4};
    private final Met met = Met.of(Motion.WEIGHTLESS, Motion.sphere(0, 5, 0, 1), Motion.sphere(2, 5, 0, 1));
    private final SolvedContact meeting = new SolvedContact(impulses, met.meeting().rules);

    @Test
    void changesTheImpulsesOfItsOwnContactAlone() {
        meeting.at = 4;

        meeting.turn(-1);

        assertThat(impulses).containsExactly(9, 9, 9, 9, -1, -2, -3, 4);
        assertThat(meeting.built()).isEqualTo(4);
        meeting.clear();
        assertThat(impulses).containsExactly(9, 9, 9, 9, 0, 0, 0, 0);
    }

    @Test
    void theMoveIsThatOfTheFirstBodyRelativeToTheSecond() {
        met.move(1, 1, 2, 3).move(2, 0.5, 0, -1).between(1, 2);

        assertThat(met.meeting().moveX).isEqualTo(0.5);
        assertThat(met.meeting().moveY).isEqualTo(2);
        assertThat(met.meeting().moveZ).isEqualTo(4);
        assertThat(met.meeting().path()).isEqualTo(20.25);
    }
}
