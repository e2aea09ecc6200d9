package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Spheres that all overlap each other, so that every pair is in contact. */
class PileTest {
    private static final int MOST_CONTACTS_OF_ONE = 80;

    @ParameterizedTest
    @ValueSource(ints = {500, 3000})
    void contactsGrowAsTheSpheresDoNotAsTheirPairs(int count) {
        Random random = new Random(1);
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            spheres.add(Motion.sphere(random.nextDouble(), 2 + random.nextDouble(), random.nextDouble(), 1));
        }
        Scene scene = Motion.scene(Physics.DEFAULT, 20, spheres);
        BodyStore bodies = new BodyStore(scene, spheres);
        spheres.forEach(sphere -> bodies.add(sphere.position(), sphere.radius()));
        try (Team team = new Team(1)) {
            ContactSearch search = new ContactSearch(bodies, Surroundings.of(scene, MeshCollider.EMPTY), team, 1, 1);
            search.search(new BodyPasses(bodies, team, 1).reach(0.05, 4, 0.001), false);
            int contacts = 0;
            for (int list = 0; list < search.lists(); list++) {
                contacts += search.contacts(list).count;
            }
            assertThat(contacts).isBetween(10 * count, MOST_CONTACTS_OF_ONE * count);
        }
    }
}
