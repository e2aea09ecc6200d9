package dev.twister.physics;

/**
 * Contact solver. A contact is either an impact, which is resolved at once by Newton's law of restitution as of the
 * time of the collision, or a resting contact, whose impulse accumulates from sub-step to sub-step so that it carries
 * the load (accumulated impulses: Catto, "Iterative Dynamics with Temporal Coherence", 2005; many small steps instead
 * of many iterations: Macklin et al., "Small Steps in Physics Simulation", 2019). Both have Coulomb friction. Overlaps
 * are corrected slowly by position, without adding speed.
 *
 * <p>All speeds are displacements per sub-step.
 */
final class ContactSolver {
    /** Share of an overlap that is corrected per sub-step. */
    private static final double PUSH_SHARE = 0.2;

    /**
     * Largest correction of a pair per sub-step, in diameters of the smaller body: initial overlaps must not make
     * bodies jump.
     */
    private static final double MOST_PUSH = 0.02;

    /** As above for ground and walls, in radii; larger, because they must hold any number of bodies. */
    private static final double MOST_SURFACE_PUSH = 0.05;

    /**
     * Limit of the load that a resting contact may add per sub-step, in weights of its lighter body, so that a body
     * between a heavy one and the ground gets similar loads from both. The next sub-step solves its warm-start loads in
     * one sweep; whatever that sweep does not take back of a shock's impulse, hundreds of weights, would become speed
     * from nothing.
     */
    private static final double MOST_NEW_LOAD = 8;

    /** Overlap that is not corrected, in radii, so that resting bodies keep touching. */
    private static final double SLOP = 0.005;

    /** Gap in radii within which a moving body wakes a sleeping one. */
    private static final double WAKE_GAP = 0.1;

    /** Relative to the pair's radii: centers closer than this count as coincident. */
    private static final double COINCIDENT = 1e-9;

    /** Ratio of the radii from which the lighter body yields to the heavier one only if nothing holds it. */
    private static final double UNEQUAL_RADII = 3;

    /**
     * Distance in the list between contacts that are solved in succession. A body's contacts are adjacent; at this
     * distance they are independent, so the CPU overlaps their work.
     */
    private static final int CONTACTS_APART = 7;

    private final BodyStore bodies;
    private final double[] numbers;
    private final Surroundings surroundings;
    private final Backing backing;
    private double gravityX;
    private double gravityY;
    private double gravityZ;
    private final double friction;
    private final boolean bracing;
    private final double pushShare;
    private double mostNewLoad;
    private double impactSpeed;
    private double wakeSpeedSquared;

    private ContactSolver(BodyStore bodies, Surroundings surroundings, boolean bracing) {
        this.bracing = bracing;
        pushShare = bracing ? 0 : PUSH_SHARE;
        this.bodies = bodies;
        this.surroundings = surroundings;
        backing = new Backing(bodies, surroundings);
        numbers = bodies.numbers;
        friction = surroundings.friction();
    }

    /** A solver that moves the bodies of a sub-step. */
    static ContactSolver moving(BodyStore bodies, Surroundings surroundings) {
        return new ContactSolver(bodies, surroundings, false);
    }

    /**
     * A solver that only finds loads, without limit: it corrects no overlaps, causes no bounces and wakes no bodies.
     */
    static ContactSolver bracing(BodyStore bodies, Surroundings surroundings) {
        return new ContactSolver(bodies, surroundings, true);
    }

    /** Sets the length of the sub-steps, in seconds. */
    void setSubstep(double seconds) {
        double square = seconds * seconds;
        gravityX = surroundings.gravity().x() * square;
        gravityY = surroundings.gravity().y() * square;
        gravityZ = surroundings.gravity().z() * square;
        double strength = surroundings.gravityStrength();
        mostNewLoad = bracing ? Double.POSITIVE_INFINITY : MOST_NEW_LOAD * strength * square;
        impactSpeed = bracing ? Double.POSITIVE_INFINITY : Rest.impactSpeed(strength) * seconds;
        wakeSpeedSquared = bracing ? Double.POSITIVE_INFINITY : Rest.wakeSpeedSquared(strength) * square;
    }

    /**
     * Solves the contacts of a list.
     *
     * @param from the first contact
     * @param to the index after the last one
     */
    void solve(Contacts contacts, int from, int to) {
        contacts.fetched = fetch(contacts.second, from, to);
        for (int offset = from; offset < from + CONTACTS_APART; offset++) {
            for (int contact = offset; contact < to; contact += CONTACTS_APART) {
                int other = contacts.second[contact];
                if (other >= 0) {
                    solvePair(contacts, contact, contacts.first[contact], other);
                } else {
                    solveSurface(contacts.impulses, Contacts.IMPULSES * contact, contacts.first[contact], -1 - other);
                }
            }
        }
    }

    /**
     * Prefetches every cache line of the second bodies, so that their cache misses overlap. The solver alone would
     * request few at a time: square roots and divisions keep the CPU from running far ahead.
     *
     * @return a value that keeps C2 from eliminating the reads
     */
    private long fetch(int[] second, int from, int to) {
        long bits = 0;
        for (int contact = from; contact < to; contact++) {
            int at = BodyStore.STRIDE * Math.max(0, second[contact]);
            bits += Double.doubleToRawLongBits(numbers[at])
                    + Double.doubleToRawLongBits(numbers[at + BodyStore.STRIDE / 2])
                    + Double.doubleToRawLongBits(numbers[at + BodyStore.STRIDE - 1]);
        }
        return bits;
    }

    /** Solves the unbalanced contacts of a list once. */
    void solveUnbalanced(Contacts contacts) {
        for (int index = 0; index < contacts.unbalancedCount; index++) {
            int contact = contacts.unbalanced[index];
            solve(contacts, contact, contact + 1);
        }
    }

    private void solvePair(Contacts contacts, int contact, int one, int two) {
        int a = BodyStore.STRIDE * one;
        int b = BodyStore.STRIDE * two;
        double[] n = numbers;
        double px = n[a] - n[b];
        double py = n[a + 1] - n[b + 1];
        double pz = n[a + 2] - n[b + 2];
        double radii = n[a + BodyStore.RADIUS] + n[b + BodyStore.RADIUS];
        double square = px * px + py * py + pz * pz;
        double outside = square - radii * radii;
        double[] impulses = contacts.impulses;
        int at = Contacts.IMPULSES * contact;
        double ofLighter = Math.max(n[a + BodyStore.INVERSE_MASS], n[b + BodyStore.INVERSE_MASS]);
        if (n[a + BodyStore.INVERSE_MASS] == 0 || n[b + BodyStore.INVERSE_MASS] == 0) {
            wake(one, two, square, radii);
            // A sleeping body too must not carry more than it could bear awake.
            ofLighter = Math.max(inverseMassAwake(one), inverseMassAwake(two));
        }
        double dx = n[a + BodyStore.MOVE] - n[b + BodyStore.MOVE];
        double dy = n[a + BodyStore.MOVE + 1] - n[b + BodyStore.MOVE + 1];
        double dz = n[a + BodyStore.MOVE + 2] - n[b + BodyStore.MOVE + 2];
        double closing = px * dx + py * dy + pz * dz;
        boolean loaded = impulses[at + Contacts.BUILT] != 0;
        if (outside > 0 && !loaded && missed(outside, closing, dx * dx + dy * dy + dz * dz)) {
            return;
        }
        double wa = n[a + BodyStore.INVERSE_MASS];
        double wb = n[b + BodyStore.INVERSE_MASS];
        if (wa + wb == 0) {
            return;
        }
        double distance = Math.sqrt(square);
        double nx;
        double ny;
        double nz;
        if (distance > COINCIDENT * radii) {
            double inverse = 1 / distance;
            nx = px * inverse;
            ny = py * inverse;
            nz = pz * inverse;
            if (Math.max(n[a + BodyStore.RADIUS], n[b + BodyStore.RADIUS])
                            > UNEQUAL_RADII * Math.min(n[a + BodyStore.RADIUS], n[b + BodyStore.RADIUS])
                    && solveUnequal(impulses, at, one, two, nx, ny, nz, distance, radii, outside)) {
                return;
            }
            // Displacement by warm-started loads is not an impact: the other contacts of the body take it back.
            if (!loaded
                    && -closing * inverse > impactSpeed + n[a + BodyStore.CARRIED] + n[b + BodyStore.CARRIED]
                    && impact(impulses, at, a, b, false, px, py, pz, outside, closing, dx * dx + dy * dy + dz * dz)) {
                return;
            }
        } else {
            // Any direction will do; it depends on the bodies' numbers, so that many bodies at one point spread.
            int axis = (one + two) % 3;
            nx = axis == 0 ? 1 : 0;
            ny = axis == 1 ? 1 : 0;
            nz = axis == 2 ? 1 : 0;
        }
        double gap = distance - radii;
        double most = 2 * MOST_PUSH * Math.min(n[a + BodyStore.RADIUS], n[b + BodyStore.RADIUS]);
        double push = Math.max(0, Math.min(pushShare * (-gap - SLOP * radii), most));
        hold(impulses, at, a, b, wa, wb, ofLighter, nx, ny, nz, dx, dy, dz, gap, push);
    }

    /**
     * Solves a contact of a heavy body with a light one that cannot yield.
     *
     * @param nx with ny and nz: the normal, toward the first body
     * @return false if the light body can move, so that the contact is an ordinary one
     */
    private boolean solveUnequal(
            double[] impulses,
            int at,
            int one,
            int two,
            double nx,
            double ny,
            double nz,
            double distance,
            double radii,
            double outside) {
        boolean firstIsHeavy =
                numbers[BodyStore.STRIDE * one + BodyStore.RADIUS] > numbers[BodyStore.STRIDE * two + BodyStore.RADIUS];
        int light = firstIsHeavy ? two : one;
        double sign = firstIsHeavy ? 1 : -1;
        int a = BodyStore.STRIDE * (firstIsHeavy ? one : two);
        int b = BodyStore.STRIDE * light;
        boolean firm = numbers[a + BodyStore.INVERSE_MASS] > 0
                && (numbers[b + BodyStore.INVERSE_MASS] == 0
                        || backing.holds(light, -sign * nx, -sign * ny, -sign * nz));
        if (firm) {
            turn(impulses, at, sign);
            solveBacked(impulses, at, a, b, sign * nx, sign * ny, sign * nz, distance, radii, outside);
            turn(impulses, at, sign);
        } else if (impulses[at + Contacts.BUILT] < 0) {
            // The light body carried this load as part of its support; alone it would be ejected.
            clear(impulses, at);
        }
        return firm;
    }

    /** Converts a contact's impulses so that they act on the heavy body, if that is the second one, and back. */
    private static void turn(double[] impulses, int at, double sign) {
        impulses[at] *= sign;
        impulses[at + 1] *= sign;
        impulses[at + 2] *= sign;
    }

    /**
     * Solves the contact of a heavy body with a light one that cannot yield and acts like the ground.
     *
     * @param nx with ny and nz: the normal, toward the heavy body
     */
    private void solveBacked(
            double[] impulses,
            int at,
            int heavy,
            int light,
            double nx,
            double ny,
            double nz,
            double distance,
            double radii,
            double outside) {
        double[] n = numbers;
        boolean asleep = n[light + BodyStore.INVERSE_MASS] == 0;
        if (!asleep) {
            // It cannot move away, and its mass is too small to lift the heavy body.
            changeMove(light, -Math.max(0, along(light, nx, ny, nz)), nx, ny, nz);
        }
        double dx = n[heavy + BodyStore.MOVE] - n[light + BodyStore.MOVE];
        double dy = n[heavy + BodyStore.MOVE + 1] - n[light + BodyStore.MOVE + 1];
        double dz = n[heavy + BodyStore.MOVE + 2] - n[light + BodyStore.MOVE + 2];
        double path = dx * dx + dy * dy + dz * dz;
        double parting = dx * nx + dy * ny + dz * nz;
        double px = distance * nx;
        double py = distance * ny;
        double pz = distance * nz;
        double gap = distance - radii;
        backing.touch(heavy / BodyStore.STRIDE, nx, ny, nz, gap / n[light + BodyStore.RADIUS]);
        boolean fast = impulses[at + Contacts.BUILT] == 0 && -parting > impactSpeed + n[heavy + BodyStore.CARRIED];
        if (!(fast && impact(impulses, at, heavy, light, true, px, py, pz, outside, parting * distance, path))) {
            double diameter = 2 * n[light + BodyStore.RADIUS];
            double lift = push(-gap - SLOP * (radii - diameter), diameter);
            if (!asleep) {
                changePlace(light, -push(-gap, diameter), nx, ny, nz);
                // Only a light body that is pushed against the ground lifts the heavy one, not one pushed by its
                // neighbors.
                lift = push(Math.min(backing.sunk(light / BodyStore.STRIDE, -nx, -ny, -nz), -gap), diameter);
            }
            double weight = n[heavy + BodyStore.INVERSE_MASS];
            impulses[at + Contacts.BUILT] = Math.abs(impulses[at + Contacts.BUILT]);
            hold(impulses, at, heavy, light, weight, 0, weight, nx, ny, nz, dx, dy, dz, gap, lift);
            impulses[at + Contacts.BUILT] = -impulses[at + Contacts.BUILT];
        }
        if (!asleep) {
            double left = along(heavy, nx, ny, nz) - along(light, nx, ny, nz) + Math.max(0, gap);
            changeMove(light, Math.min(0, left), nx, ny, nz);
        }
    }

    private double along(int at, double nx, double ny, double nz) {
        return numbers[at + BodyStore.MOVE] * nx
                + numbers[at + BodyStore.MOVE + 1] * ny
                + numbers[at + BodyStore.MOVE + 2] * nz;
    }

    private double push(double overlap, double diameter) {
        return Math.max(0, Math.min(pushShare * (overlap - SLOP * diameter), MOST_PUSH * diameter));
    }

    private void changePlace(int at, double length, double nx, double ny, double nz) {
        numbers[at] += length * nx;
        numbers[at + 1] += length * ny;
        numbers[at + 2] += length * nz;
    }

    private void changeMove(int at, double length, double nx, double ny, double nz) {
        numbers[at + BodyStore.MOVE] += length * nx;
        numbers[at + BodyStore.MOVE + 1] += length * ny;
        numbers[at + BodyStore.MOVE + 2] += length * nz;
    }

    /**
     * Resting contact: lets two bodies at most close the gap between them, and limits their sliding by friction.
     *
     * @param at start of the contact's impulses
     * @param b start of the second body's values; not read if its inverse mass is 0
     * @param wa the first body's inverse mass; wb the second one's
     * @param ofLighter inverse mass of the lighter body, even if it sleeps
     * @param nx with ny and nz: the normal, toward the first body
     * @param dx with dy and dz: the first body's displacement relative to the second one
     * @param push how far to push the bodies apart
     */
    private void hold(
            double[] impulses,
            int at,
            int a,
            int b,
            double wa,
            double wb,
            double ofLighter,
            double nx,
            double ny,
            double nz,
            double dx,
            double dy,
            double dz,
            double gap,
            double push) {
        double mass = 1 / (wa + wb);
        double ox = impulses[at];
        double oy = impulses[at + 1];
        double oz = impulses[at + 2];
        // The impulse that would stop the relative motion, including the warm start.
        double qx = ox - mass * dx;
        double qy = oy - mass * dy;
        double qz = oz - mass * dz;
        double along = qx * nx + qy * ny + qz * nz;
        double built = Math.max(0, along - Math.max(0, gap) * mass);
        double tx = qx - along * nx;
        double ty = qy - along * ny;
        double tz = qz - along * nz;
        double across = tx * tx + ty * ty + tz * tz;
        // No branch, because it would be unpredictable; the tiny addition avoids 0 / 0.
        double share = Math.min(1, friction * built / Math.sqrt(across + Double.MIN_NORMAL));
        double ix = built * nx + share * tx;
        double iy = built * ny + share * ty;
        double iz = built * nz + share * tz;
        double sx = ix - ox;
        double sy = iy - oy;
        double sz = iz - oz;
        double old = impulses[at + Contacts.BUILT];
        if ((built - old) * ofLighter > mostNewLoad) {
            double load = old + mostNewLoad / ofLighter;
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
        apply(a, wa, sx, sy, sz, px, py, pz, ix, iy, iz);
        apply(b, -wb, sx, sy, sz, px, py, pz, ix, iy, iz);
    }

    /**
     * Resolves an impact where the paths of this sub-step meet; if they met earlier, slightly back in time.
     *
     * @param firm whether the second body is as firm as the ground
     * @return false if the paths do not meet within the sub-step
     */
    private boolean impact(
            double[] impulses,
            int at,
            int a,
            int b,
            boolean firm,
            double px,
            double py,
            double pz,
            double outside,
            double closing,
            double path) {
        double root = closing * closing - path * outside;
        if (root < 0) {
            return false;
        }
        double time = (-closing - Math.sqrt(root)) / path;
        if (time > 1) {
            return false;
        }
        time = Math.max(time, -1);
        double[] n = numbers;
        double dx = n[a + BodyStore.MOVE] - n[b + BodyStore.MOVE];
        double dy = n[a + BodyStore.MOVE + 1] - n[b + BodyStore.MOVE + 1];
        double dz = n[a + BodyStore.MOVE + 2] - n[b + BodyStore.MOVE + 2];
        double nx = px + time * dx;
        double ny = py + time * dy;
        double nz = pz + time * dz;
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
        double wa = inverseMassWhenHit(a);
        double wb = firm ? 0 : inverseMassWhenHit(b);
        double both = wa + wb;
        double impulse = -(1 + surroundings.elasticity()) * along / both;
        double tx = along * nx - dx;
        double ty = along * ny - dy;
        double tz = along * nz - dz;
        double sliding = Math.sqrt(tx * tx + ty * ty + tz * tz);
        double share = sliding > 0 ? Math.min(1 / both, friction * impulse / sliding) : 0;
        double sx = impulse * nx + share * tx;
        double sy = impulse * ny + share * ty;
        double sz = impulse * nz + share * tz;
        clear(impulses, at);
        // Until the collision the bodies keep their old velocities, afterwards they have the new ones.
        apply(a, wa, sx, sy, sz, -time * sx, -time * sy, -time * sz, 0, 0, 0);
        apply(b, wb, -sx, -sy, -sz, time * sx, time * sy, time * sz, 0, 0, 0);
        return true;
    }

    /** The inverse mass in an impact: a roused body moves at once. */
    private double inverseMassWhenHit(int at) {
        int body = at / BodyStore.STRIDE;
        if (numbers[at + BodyStore.INVERSE_MASS] == 0 && bodies.state[body] == BodyStore.WOKEN) {
            bodies.free(body);
        }
        return numbers[at + BodyStore.INVERSE_MASS];
    }

    private void solveSurface(double[] impulses, int at, int body, int surface) {
        if (numbers[BodyStore.STRIDE * body + BodyStore.INVERSE_MASS] != 0) {
            if (surface < Surroundings.FIRST_TRIANGLE) {
                solveFlat(impulses, at, body, surface);
            } else {
                solveTriangle(impulses, at, BodyStore.STRIDE * body, surface - Surroundings.FIRST_TRIANGLE);
            }
        }
    }

    private void solveTriangle(double[] impulses, int at, int a, int sideOfTriangle) {
        double[] n = numbers;
        int triangle = sideOfTriangle >> 1;
        TriangleContact contact = surroundings.mesh().contact(triangle);
        contact.meet(
                n[a],
                n[a + 1],
                n[a + 2],
                sideOfTriangle & 1,
                n[a + BodyStore.MOVE],
                n[a + BodyStore.MOVE + 1],
                n[a + BodyStore.MOVE + 2]);
        if (surroundings.mesh().isNearerAcross(triangle, contact)) {
            clear(impulses, at);
        } else {
            meetSurface(impulses, at, a, contact.x, contact.y, contact.z, contact.distance);
        }
    }

    private void solveFlat(double[] impulses, int at, int body, int surface) {
        int a = BodyStore.STRIDE * body;
        double[] n = numbers;
        double nx = 0;
        double ny = 0;
        double nz = 0;
        double distance;
        if (surface == Surroundings.GROUND) {
            double up = n[a + 1] - surroundings.height();
            double outX = n[a] - surroundings.nearest(n[a]);
            double outZ = n[a + 2] - surroundings.nearest(n[a + 2]);
            if (outX == 0 && outZ == 0) {
                ny = bodies.side[body];
                distance = ny * up;
            } else {
                distance = Math.sqrt(outX * outX + up * up + outZ * outZ);
                nx = outX / distance;
                ny = up / distance;
                nz = outZ / distance;
            }
        } else {
            int wall = surface - Surroundings.FIRST_WALL;
            distance = surroundings.halfSide() - surroundings.towardsWall(wall, n[a], n[a + 2]);
            double inwards = wall % 2 == 0 ? -1 : 1;
            nx = wall < 2 ? inwards : 0;
            nz = wall < 2 ? 0 : inwards;
        }
        meetSurface(impulses, at, a, nx, ny, nz, distance);
    }

    /**
     * Solves the contact of a body with a fixed surface.
     *
     * @param nx with ny and nz: the normal, toward the body
     * @param distance signed distance of the body's center from the surface, in meters; negative behind it
     */
    private void meetSurface(double[] impulses, int at, int a, double nx, double ny, double nz, double distance) {
        double[] n = numbers;
        double weight = n[a + BodyStore.INVERSE_MASS];
        double radius = n[a + BodyStore.RADIUS];
        double gap = distance - radius;
        double dx = n[a + BodyStore.MOVE];
        double dy = n[a + BodyStore.MOVE + 1];
        double dz = n[a + BodyStore.MOVE + 2];
        double along = dx * nx + dy * ny + dz * nz;
        double old = impulses[at + Contacts.BUILT];
        if (old == 0 && gap + along >= 0) {
            return;
        }
        double pull = gravityX * nx + gravityY * ny + gravityZ * nz;
        // The start of the sub-step is half a sub-step before the time of the move.
        double atStart = along - pull / 2;
        double tx = along * nx - dx;
        double ty = along * ny - dy;
        double tz = along * nz - dz;
        if (old == 0 && -atStart > impactSpeed + n[a + BodyStore.CARRIED]) {
            double met = Math.max(gap, along);
            // By energy: the speed at the surface, and the remaining speed after the bounce.
            double hit = Math.max(0, atStart * atStart - 2 * pull * met);
            double e = surroundings.elasticity();
            double left = Math.sqrt(Math.max(0, e * e * hit - 2 * pull * e * met)) + pull / 2;
            double impulse = Math.max(0, left - along);
            double sliding = Math.sqrt(tx * tx + ty * ty + tz * tz);
            double share = sliding > 0 ? Math.min(1, friction * impulse / sliding) : 0;
            clear(impulses, at);
            double back = -(1 + e) * met;
            applyOnce(
                    a,
                    impulse * nx + share * tx,
                    impulse * ny + share * ty,
                    impulse * nz + share * tz,
                    back * nx,
                    back * ny,
                    back * nz);
            return;
        }
        double push = Math.max(0, Math.min(pushShare * (-gap - SLOP * radius), MOST_SURFACE_PUSH * radius));
        hold(impulses, at, a, a, weight, 0, weight, nx, ny, nz, dx, dy, dz, gap, push);
    }

    // Detects a miss without a root: moving apart, never near enough, or not yet within this sub-step.
    private static boolean missed(double outside, double closing, double path) {
        return closing >= 0
                || closing * closing < path * outside
                || (-closing > path && outside + 2 * closing + path > 0);
    }

    private double inverseMassAwake(int body) {
        return body == BodyStore.LIGHT ? 0 : bodies.inverseMass(numbers[BodyStore.STRIDE * body + BodyStore.RADIUS]);
    }

    private void wake(int one, int two, double square, double radii) {
        double near = (1 + WAKE_GAP) * radii;
        if (square < near * near) {
            wakeBy(one, two);
            wakeBy(two, one);
        }
    }

    private void wakeBy(int sleeper, int mover) {
        int at = BodyStore.STRIDE * mover + BodyStore.MOVE;
        double speedSquared =
                numbers[at] * numbers[at] + numbers[at + 1] * numbers[at + 1] + numbers[at + 2] * numbers[at + 2];
        boolean hit = speedSquared > wakeSpeedSquared * numbers[BodyStore.STRIDE * sleeper + BodyStore.RADIUS];
        if (hit && bodies.state[sleeper] == BodyStore.ASLEEP && sleeper != BodyStore.LIGHT) {
            bodies.rouse(sleeper);
        }
    }

    private static void clear(double[] impulses, int at) {
        impulses[at] = 0;
        impulses[at + 1] = 0;
        impulses[at + 2] = 0;
        impulses[at + 3] = 0;
    }

    private void applyOnce(int a, double dx, double dy, double dz, double px, double py, double pz) {
        apply(a, 1, dx, dy, dz, px, py, pz, 0, 0, 0);
    }

    /**
     * Adds an impulse to a body's move, a push to its position, and a load to its warm start.
     *
     * @param weight the body's inverse mass, negative for the opposite direction
     */
    private void apply(
            int a,
            double weight,
            double sx,
            double sy,
            double sz,
            double px,
            double py,
            double pz,
            double cx,
            double cy,
            double cz) {
        if (weight != 0) {
            double[] n = numbers;
            n[a] += weight * px;
            n[a + 1] += weight * py;
            n[a + 2] += weight * pz;
            n[a + BodyStore.MOVE] += weight * sx;
            n[a + BodyStore.MOVE + 1] += weight * sy;
            n[a + BodyStore.MOVE + 2] += weight * sz;
            n[a + BodyStore.SUPPORT] += weight * cx;
            n[a + BodyStore.SUPPORT + 1] += weight * cy;
            n[a + BodyStore.SUPPORT + 2] += weight * cz;
        }
    }
}
