package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Physics;
import dev.twister.scene.Vector3;
import org.junit.jupiter.api.Test;

class ContactRulesTest {
    private static final Surroundings SURROUNDINGS = Met.of(
                    Physics.DEFAULT.withGravity(new Vector3(0, -10, 0)), Motion.sphere(0, 1, 0, 1))
            .surroundings();

    @Test
    void scaleWithTheSubstep() {
        ContactRules rules = ContactRules.moving(SURROUNDINGS, 0.5);

        assertThat(rules.gravity()).isEqualTo(new Vector3(0, -2.5, 0));
        assertThat(rules.mostNewLoad()).isEqualTo(8 * 2.5);
        assertThat(rules.impactSpeed()).isCloseTo(Rest.impactSpeed(10) * 0.5, within(1e-12));
        assertThat(rules.wakeSpeedSquared()).isCloseTo(Rest.wakeSpeedSquared(10) * 0.25, within(1e-12));
    }

    @Test
    void bracingOnlyFindsLoads() {
        ContactRules rules = ContactRules.bracing(SURROUNDINGS, 0.5);

        assertThat(rules.pushShare()).isZero();
        assertThat(rules.mostNewLoad()).isInfinite();
        assertThat(rules.impactSpeed()).isInfinite();
        assertThat(rules.wakeSpeedSquared()).isInfinite();
    }
}
