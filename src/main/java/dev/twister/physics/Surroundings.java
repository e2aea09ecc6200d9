package dev.twister.physics;

import dev.twister.scene.Ground;
import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;

/**
 * All fixed obstacles: the plane's square, which is touched from above, from below and at its border; four walls on the
 * border; and meshes.
 *
 * @param halfSide half side of the square, in meters
 * @param height the plane's y, in meters
 * @param gravity in m/s^2
 */
record Surroundings(
        double halfSide,
        double height,
        Vector3 gravity,
        double elasticity,
        double friction,
        double damping,
        MeshCollider mesh) {
    static final int GROUND = 0;
    static final int FIRST_WALL = 1;

    /** In the order: at maximum x, minimum x, maximum z, minimum z. */
    static final int WALLS = 4;

    /** After the walls: two surfaces per triangle of the mesh, one per side. */
    static final int FIRST_TRIANGLE = FIRST_WALL + WALLS;

    static Surroundings of(Scene scene, MeshCollider mesh) {
        Ground plane = scene.ground();
        Physics physics = scene.physics();
        return new Surroundings(
                plane.size() / 2,
                plane.height(),
                physics.gravity(),
                physics.elasticity(),
                physics.friction(),
                physics.damping(),
                mesh);
    }

    double gravityStrength() {
        return gravity.length();
    }

    /** The unit vector against gravity; zero without gravity. */
    Vector3 up() {
        return gravityStrength() == 0 ? Vector3.ZERO : gravity.times(-1).normalized();
    }

    boolean isOver(double x, double z) {
        return Math.abs(x) <= halfSide && Math.abs(z) <= halfSide;
    }

    /** x (or z) of the square's point nearest to a point with that x (or z). */
    double nearest(double coordinate) {
        return Math.max(-halfSide, Math.min(halfSide, coordinate));
    }

    /** Distance of a point from the y axis toward a wall, in meters. */
    double towardsWall(int wall, double x, double z) {
        double along = wall < 2 ? x : z;
        return wall % 2 == 0 ? along : -along;
    }
}
