package dev.twister.gui.model;

import dev.twister.render.FilmBodies;
import dev.twister.scene.Vector3;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;

/** Bodies where a picture shows them. */
final class SeenBodies {
    private SeenBodies() {}

    /**
     * Puts a world's bodies there.
     *
     * @param seen of a scene with the same spheres, poured ones included
     */
    static FilmBodies of(FrameInput seen) {
        Bodies bodies = seen.bodies();
        return (world, _) -> {
            Vector3 way = bodies.origin().minus(world.origin());
            double[] shift = {way.x(), way.y(), way.z()};
            float[] positions = new float[shift.length * bodies.room()];
            for (int i = 0; i < positions.length; i++) {
                int axis = i % shift.length;
                positions[i] = (float) (bodies.center(i / shift.length, axis) + shift[axis]);
            }
            world.setBodyPositions(positions, seen.bodyCount());
        };
    }
}
