package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Physics;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.List;
import org.junit.jupiter.api.Test;

final class BodyStoreTest {
    /** Bodies that differ in every value that steps read before they set it. */
    @Test
    void reorderedBodiesKeepTheirState() {
        List<Sphere> spheres = List.of(Motion.sphere(1, 2, 3, 0.5), Motion.sphere(4, 5, 6, 0.25));
        BodyStore bodies = new BodyStore(Motion.scene(Physics.DEFAULT, 10, spheres), spheres);
        spheres.forEach(sphere -> bodies.add(sphere.position(), sphere.radius()));
        bodies.sleep(2);
        bodies.calmSteps[1] = 7;
        bodies.held[1] = 3;
        bodies.side[1] = -1;
        bodies.walled[1] = true;
        bodies.setMove(1, 0.1, 0.2, 0.3);

        bodies.reorder(new int[] {0, 2, 1});

        assertThat(bodies.bodiesOfSpheres()).containsExactly(2, 1);
        assertThat(position(bodies, 1)).isEqualTo(new Vector3(4, 5, 6));
        assertThat(bodies.state).containsExactly(BodyStore.ASLEEP, BodyStore.ASLEEP, BodyStore.AWAKE);
        assertThat(bodies.calmSteps).containsExactly(0, 0, 7);
        assertThat(bodies.held).containsExactly(0, 0, 3);
        assertThat(bodies.side[2]).isEqualTo((byte) -1);
        assertThat(bodies.walled[2]).isTrue();
        assertThat(bodies.numbers[BodyStore.STRIDE * 2 + BodyStore.MOVE + 1]).isEqualTo(0.2);
    }

    private static Vector3 position(BodyStore bodies, int body) {
        int at = BodyStore.STRIDE * body + BodyStore.POSITION;
        return new Vector3(bodies.numbers[at], bodies.numbers[at + 1], bodies.numbers[at + 2]);
    }
}
