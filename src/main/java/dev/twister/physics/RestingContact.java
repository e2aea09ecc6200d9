package dev.twister.physics;

/**
 * Resting contact: lets two bodies at most close the gap between them, and limits their sliding by friction. Its
 * impulse accumulates from sub-step to sub-step so that it carries the load.
 */
final class RestingContact {
    private final double[] numbers;

    RestingContact(BodyStore bodies) {
        numbers = bodies.numbers;
    }

    /**
     * Solves the contact.
     *
     * @param firstWeight inverse masses; 0 for what does not move
     * @param ofLighter inverse mass of the lighter body, even if it sleeps
     * @param gap distance between the surfaces, in meters; negative if they overlap
     * @param push how far to push the bodies apart
     */
    void hold(
            SolvedContact meeting, double firstWeight, double secondWeight, double ofLighter, double gap, double push) {
        double nx = meeting.normalX;
        double ny = meeting.normalY;
        double nz = meeting.normalZ;
        double[] impulses = meeting.impulses;
        int at = meeting.at;
        double mass = 1 / (firstWeight + secondWeight);
        double ox = impulses[at];
        double oy = impulses[at + 1];
        double oz = impulses[at + 2];
        // The impulse that would stop the relative motion, including the warm start.
        double qx = ox - mass * meeting.moveX;
        double qy = oy - mass * meeting.moveY;
        double qz = oz - mass * meeting.moveZ;
        double along = qx * nx + qy * ny + qz * nz;
        double built = Math.max(0, along - Math.max(0, gap) * mass);
        double tx = qx - along * nx;
        double ty = qy - along * ny;
        double tz = qz - along * nz;
        double across = tx * tx + ty * ty + tz * tz;
        // No branch, because it would be unpredictable; the tiny addition avoids 0 / 0.
        double share = Math.min(1, meeting.rules.friction() * built / Math.sqrt(across + Double.MIN_NORMAL));
        double ix = built * nx + share * tx;
        double iy = built * ny + share * ty;
        double iz = built * nz + share * tz;
        double sx = ix - ox;
        double sy = iy - oy;
        double sz = iz - oz;
        double old = impulses[at + Contacts.BUILT];
        if ((built - old) * ofLighter > meeting.rules.mostNewLoad()) {
            double load = old + meeting.rules.mostNewLoad() / ofLighter;
            double kept = load / built;
            built = load;
            ix *= kept;
            iy *= kept;
            iz *= kept;
        }
        impulses[at] = ix;
        impulses[at + 1] = iy;
        impulses[at + 2] = iz;
        impulses[at + Contacts.BUILT] = built;
        double px = push * mass * nx;
        double py = push * mass * ny;
        double pz = push * mass * nz;
        double[] n = numbers;
        if (firstWeight != 0) {
            BodyStore.add(n, meeting.first, firstWeight, px, py, pz);
            BodyStore.add(n, meeting.first + BodyStore.MOVE, firstWeight, sx, sy, sz);
            BodyStore.add(n, meeting.first + BodyStore.SUPPORT, firstWeight, ix, iy, iz);
        }
        if (secondWeight != 0) {
            BodyStore.add(n, meeting.second, -secondWeight, px, py, pz);
            BodyStore.add(n, meeting.second + BodyStore.MOVE, -secondWeight, sx, sy, sz);
            BodyStore.add(n, meeting.second + BodyStore.SUPPORT, -secondWeight, ix, iy, iz);
        }
    }
}
