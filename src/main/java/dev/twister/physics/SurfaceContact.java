package dev.twister.physics;

import dev.twister.scene.Vector3;

/** Contact of a body with a surface: the ground, a wall or a triangle, which may move. */
final class SurfaceContact {
    /** Largest correction per sub-step, in radii; larger than that of pairs, as it must hold any number of bodies. */
    private static final double MOST_PUSH = 0.05;

    private final BodyStore bodies;
    private final double[] numbers;
    private final Surroundings surroundings;
    private final RestingContact resting;

    SurfaceContact(BodyStore bodies, Surroundings surroundings) {
        this.bodies = bodies;
        this.surroundings = surroundings;
        numbers = bodies.numbers;
        resting = new RestingContact(bodies);
    }

    /**
     * Solves the contact of a body with a surface.
     *
     * @param at start of the contact's impulses
     * @param surface its number in the {@link Surroundings}
     */
    void solve(SolvedContact meeting, int at, int body, int surface) {
        int a = BodyStore.STRIDE * body;
        if (numbers[a + BodyStore.INVERSE_MASS] != 0) {
            // The second body is not used.
            meeting.at = at;
            meeting.first = a;
            meeting.second = a;
            if (surface == Surroundings.GROUND) {
                meetGround(meeting, bodies.side[body]);
            } else if (surface < Surroundings.FIRST_TRIANGLE) {
                meetWall(meeting, surface - Surroundings.FIRST_WALL);
            } else {
                meetTriangle(meeting, surface - Surroundings.FIRST_TRIANGLE);
            }
        }
    }

    private void meetTriangle(SolvedContact meeting, int sideOfTriangle) {
        double[] n = numbers;
        int a = meeting.first;
        int triangle = sideOfTriangle >> 1;
        MeshCollider mesh = surroundings.mesh();
        if (!mesh.hasArea(triangle)) {
            meeting.clear();
            return;
        }
        TriangleContact contact = mesh.contact(triangle);
        int side = sideOfTriangle & 1;
        double[] drifts = mesh.drifts();
        if (drifts.length > 0) {
            contact.meet(n[a], n[a + 1], n[a + 2], side, 0, 0, 0);
        }
        double dx = n[a + BodyStore.MOVE] - contact.drift(drifts, 0);
        double dy = n[a + BodyStore.MOVE + 1] - contact.drift(drifts, 1);
        double dz = n[a + BodyStore.MOVE + 2] - contact.drift(drifts, 2);
        contact.meet(n[a], n[a + 1], n[a + 2], side, dx, dy, dz);
        if (mesh.isNearerAcross(triangle, contact)) {
            meeting.clear();
        } else {
            meeting.setNormal(contact.x, contact.y, contact.z);
            meeting.setMove(dx, dy, dz);
            meet(meeting, contact.distance);
        }
    }

    private void meetGround(SolvedContact meeting, int side) {
        double[] n = numbers;
        int a = meeting.first;
        double up = n[a + 1] - surroundings.height();
        double outX = n[a] - surroundings.nearest(n[a]);
        double outZ = n[a + 2] - surroundings.nearest(n[a + 2]);
        if (outX == 0 && outZ == 0) {
            meeting.setNormal(0, side, 0);
            meetFixed(meeting, side * up);
        } else {
            double distance = Math.sqrt(outX * outX + up * up + outZ * outZ);
            meeting.setNormal(outX / distance, up / distance, outZ / distance);
            meetFixed(meeting, distance);
        }
    }

    private void meetWall(SolvedContact meeting, int wall) {
        double[] n = numbers;
        int a = meeting.first;
        double inwards = wall % 2 == 0 ? -1 : 1;
        meeting.setNormal(wall < 2 ? inwards : 0, 0, wall < 2 ? 0 : inwards);
        meetFixed(meeting, surroundings.halfSide() - surroundings.towardsWall(wall, n[a], n[a + 2]));
    }

    /** As {@link #meet}, of a surface that rests. */
    private void meetFixed(SolvedContact meeting, double distance) {
        double[] n = numbers;
        int move = meeting.first + BodyStore.MOVE;
        meeting.setMove(n[move], n[move + 1], n[move + 2]);
        meet(meeting, distance);
    }

    /**
     * Solves the contact with the surface that has the meeting's normal. The meeting's move is relative to the surface.
     *
     * @param distance signed distance of the body's center from the surface, in meters; negative behind it
     */
    private void meet(SolvedContact meeting, double distance) {
        double[] n = numbers;
        int a = meeting.first;
        double radius = n[a + BodyStore.RADIUS];
        double gap = distance - radius;
        double along =
                meeting.moveX * meeting.normalX + meeting.moveY * meeting.normalY + meeting.moveZ * meeting.normalZ;
        double old = meeting.built();
        if (old == 0 && gap + along >= 0) {
            return;
        }
        Vector3 gravity = meeting.rules.gravity();
        double pull = gravity.x() * meeting.normalX + gravity.y() * meeting.normalY + gravity.z() * meeting.normalZ;
        // The start of the sub-step is half a sub-step before the time of the move.
        double atStart = along - pull / 2;
        if (old == 0 && -atStart > meeting.rules.impactSpeed() + n[a + BodyStore.CARRIED]) {
            bounce(meeting, along, gap, pull, atStart);
        } else {
            double weight = n[a + BodyStore.INVERSE_MASS];
            double share = meeting.rules.pushShare() * (-gap - ContactRules.SLOP * radius);
            resting.hold(meeting, weight, 0, weight, gap, Math.max(0, Math.min(share, MOST_PUSH * radius)));
        }
    }

    /**
     * Resolves an impact.
     *
     * @param along the body's displacement along the normal
     * @param gap distance between body and surface
     * @param pull gravity's change of it per sub-step
     * @param atStart the displacement at the start of the sub-step
     */
    private void bounce(SolvedContact meeting, double along, double gap, double pull, double atStart) {
        double nx = meeting.normalX;
        double ny = meeting.normalY;
        double nz = meeting.normalZ;
        double tx = along * nx - meeting.moveX;
        double ty = along * ny - meeting.moveY;
        double tz = along * nz - meeting.moveZ;
        double met = Math.max(gap, along);
        // By energy: the speed at the surface, and the remaining speed after the bounce.
        double hit = Math.max(0, atStart * atStart - 2 * pull * met);
        double e = meeting.rules.elasticity();
        double left = Math.sqrt(Math.max(0, e * e * hit - 2 * pull * e * met)) + pull / 2;
        double impulse = Math.max(0, left - along);
        double sliding = Math.sqrt(tx * tx + ty * ty + tz * tz);
        double share = sliding > 0 ? Math.min(1, meeting.rules.friction() * impulse / sliding) : 0;
        meeting.clear();
        double back = -(1 + e) * met;
        int a = meeting.first;
        BodyStore.add(numbers, a, 1, back * nx, back * ny, back * nz);
        BodyStore.add(
                numbers,
                a + BodyStore.MOVE,
                1,
                impulse * nx + share * tx,
                impulse * ny + share * ty,
                impulse * nz + share * tz);
    }
}
