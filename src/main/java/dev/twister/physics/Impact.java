package dev.twister.physics;

/** Collision of two bodies, resolved at once by Newton's law of restitution as of the time of the collision. */
final class Impact {
    private final double[] numbers;
    private final Waking waking;

    Impact(BodyStore bodies) {
        numbers = bodies.numbers;
        waking = new Waking(bodies);
    }

    /**
     * Whether two bodies do not meet within a sub-step, found without a root: they move apart, are never near enough,
     * or are not yet.
     *
     * @param outside squared distance of the centers minus the squared sum of the radii
     * @param closing product of the vector between the centers and the relative displacement
     * @param path squared length of the relative displacement
     */
    static boolean missed(double outside, double closing, double path) {
        return closing >= 0
                || closing * closing < path * outside
                || (-closing > path && outside + 2 * closing + path > 0);
    }

    /**
     * Resolves an impact where the paths of this sub-step meet; if they met earlier, slightly back in time.
     *
     * @param firm whether the second body is as firm as the ground
     * @return false if the paths do not meet within the sub-step
     */
    boolean resolve(SolvedContact meeting, boolean firm) {
        double path = meeting.path();
        double root = meeting.closing * meeting.closing - path * meeting.outside;
        if (root < 0) {
            return false;
        }
        double time = (-meeting.closing - Math.sqrt(root)) / path;
        if (time > 1) {
            return false;
        }
        time = Math.max(time, -1);
        double dx = meeting.moveX;
        double dy = meeting.moveY;
        double dz = meeting.moveZ;
        double nx = meeting.placeX + time * dx;
        double ny = meeting.placeY + time * dy;
        double nz = meeting.placeZ + time * dz;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        if (length == 0) {
            return false;
        }
        nx /= length;
        ny /= length;
        nz /= length;
        double along = dx * nx + dy * ny + dz * nz;
        if (!(along < 0)) {
            return false;
        }
        double firstWeight = waking.inverseMassWhenHit(meeting.first);
        double secondWeight = firm ? 0 : waking.inverseMassWhenHit(meeting.second);
        double both = firstWeight + secondWeight;
        double impulse = -(1 + meeting.rules.elasticity()) * along / both;
        double tx = along * nx - dx;
        double ty = along * ny - dy;
        double tz = along * nz - dz;
        double sliding = Math.sqrt(tx * tx + ty * ty + tz * tz);
        double share = sliding > 0 ? Math.min(1 / both, meeting.rules.friction() * impulse / sliding) : 0;
        double sx = impulse * nx + share * tx;
        double sy = impulse * ny + share * ty;
        double sz = impulse * nz + share * tz;
        meeting.clear();
        // Until the collision the bodies keep their old velocities, afterwards they have the new ones.
        if (firstWeight != 0) {
            BodyStore.add(numbers, meeting.first, firstWeight, -time * sx, -time * sy, -time * sz);
            BodyStore.add(numbers, meeting.first + BodyStore.MOVE, firstWeight, sx, sy, sz);
        }
        if (secondWeight != 0) {
            BodyStore.add(numbers, meeting.second, secondWeight, time * sx, time * sy, time * sz);
            BodyStore.add(numbers, meeting.second + BodyStore.MOVE, secondWeight, -sx, -sy, -sz);
        }
        return true;
    }
}
