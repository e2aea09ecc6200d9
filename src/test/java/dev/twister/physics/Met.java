package dev.twister.physics;

import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneMeshes;
import java.util.List;

/** Bodies of a scene and one contact, whose impulses start at index 0. */
record Met(BodyStore bodies, Surroundings surroundings, SolvedContact meeting) {
    /** One sub-step, in seconds. */
    static final double SUBSTEP = 1;

    static Met of(Physics physics, Sphere... spheres) {
        List<Sphere> all = List.of(spheres);
        Scene scene = Motion.scene(physics, 20, all);
        BodyStore bodies = new BodyStore(scene, all);
        all.forEach(sphere -> bodies.add(sphere.position(), sphere.radius()));
        Surroundings surroundings = Surroundings.of(scene, MeshCollider.of(scene, SceneMeshes.NONE));
        return new Met(
                bodies,
                surroundings,
                new SolvedContact(new double[Contacts.IMPULSES], ContactRules.moving(surroundings, SUBSTEP)));
    }

    /** Sets the meeting's bodies, by their numbers. */
    Met between(int first, int second) {
        meeting.first = BodyStore.STRIDE * first;
        meeting.second = BodyStore.STRIDE * second;
        Vector3 one = move(first);
        Vector3 other = move(second);
        meeting.setMove(one.x() - other.x(), one.y() - other.y(), one.z() - other.z());
        return this;
    }

    Met move(int body, double x, double y, double z) {
        bodies.setMove(body, x, y, z);
        return this;
    }

    Vector3 move(int body) {
        return vector(body, BodyStore.MOVE);
    }

    Vector3 place(int body) {
        return vector(body, BodyStore.POSITION);
    }

    Vector3 support(int body) {
        return vector(body, BodyStore.SUPPORT);
    }

    private Vector3 vector(int body, int from) {
        int at = BodyStore.STRIDE * body + from;
        return new Vector3(bodies.numbers[at], bodies.numbers[at + 1], bodies.numbers[at + 2]);
    }
}
