package dev.twister.physics;

/** Contacts of a heavy body with a light one that cannot yield and acts like the ground. */
final class FirmContact {
    /**
     * Largest correction of a pair per sub-step, in diameters of the smaller body: initial overlaps must not make
     * bodies jump.
     */
    static final double MOST_PUSH = 0.02;

    private final double[] numbers;
    private final Firmness backing;
    private final RestingContact resting;
    private final Impact impact;

    FirmContact(BodyStore bodies, Surroundings surroundings) {
        numbers = bodies.numbers;
        backing = new Firmness(bodies, surroundings);
        resting = new RestingContact(bodies);
        impact = new Impact(bodies);
    }

    /**
     * Solves a contact of a heavy body with a light one, if the light one cannot yield.
     *
     * @param meeting with bodies and normal; the heavy body becomes the first one
     * @param distance of the centers, in meters
     * @param radii sum of the radii, in meters
     * @param outside squared distance of the centers minus the squared sum of the radii
     * @return false if the light body can move, so that the contact is an ordinary one
     */
    boolean solve(SolvedContact meeting, double distance, double radii, double outside) {
        boolean firstIsHeavy = numbers[meeting.first + BodyStore.RADIUS] > numbers[meeting.second + BodyStore.RADIUS];
        int heavy = firstIsHeavy ? meeting.first : meeting.second;
        int light = firstIsHeavy ? meeting.second : meeting.first;
        double sign = firstIsHeavy ? 1 : -1;
        boolean firm = numbers[heavy + BodyStore.INVERSE_MASS] > 0
                && (numbers[light + BodyStore.INVERSE_MASS] == 0
                        || backing.holds(
                                light / BodyStore.STRIDE,
                                -sign * meeting.normalX,
                                -sign * meeting.normalY,
                                -sign * meeting.normalZ));
        if (firm) {
            meeting.first = heavy;
            meeting.second = light;
            meeting.setNormal(sign * meeting.normalX, sign * meeting.normalY, sign * meeting.normalZ);
            meeting.turn(sign);
            solveBacked(meeting, distance, radii, outside);
            meeting.turn(sign);
        } else if (meeting.built() < 0) {
            // The light body carried this load as part of its support; alone it would be ejected.
            meeting.clear();
        }
        return firm;
    }

    /** Solves the contact; the first body is the heavy one. */
    private void solveBacked(SolvedContact meeting, double distance, double radii, double outside) {
        int heavy = meeting.first;
        int light = meeting.second;
        double nx = meeting.normalX;
        double ny = meeting.normalY;
        double nz = meeting.normalZ;
        boolean asleep = numbers[light + BodyStore.INVERSE_MASS] == 0;
        if (!asleep) {
            // It cannot move away, and its mass is too small to lift the heavy body.
            changeMove(meeting, -Math.max(0, along(light, meeting)));
        }
        meeting.setMove(
                numbers[heavy + BodyStore.MOVE] - numbers[light + BodyStore.MOVE],
                numbers[heavy + BodyStore.MOVE + 1] - numbers[light + BodyStore.MOVE + 1],
                numbers[heavy + BodyStore.MOVE + 2] - numbers[light + BodyStore.MOVE + 2]);
        double gap = distance - radii;
        double parting = meeting.moveX * nx + meeting.moveY * ny + meeting.moveZ * nz;
        backing.touch(heavy / BodyStore.STRIDE, nx, ny, nz, gap / numbers[light + BodyStore.RADIUS]);
        boolean fast =
                meeting.built() == 0 && -parting > meeting.rules.impactSpeed() + numbers[heavy + BodyStore.CARRIED];
        meeting.setPlace(distance * nx, distance * ny, distance * nz, outside, parting * distance);
        if (!(fast && impact.resolve(meeting, true))) {
            hold(meeting, gap, radii, asleep);
        }
        if (!asleep) {
            double left = along(heavy, meeting) - along(light, meeting) + Math.max(0, gap);
            changeMove(meeting, Math.min(0, left));
        }
    }

    private void hold(SolvedContact meeting, double gap, double radii, boolean asleep) {
        int light = meeting.second;
        double diameter = 2 * numbers[light + BodyStore.RADIUS];
        double lift = push(meeting, -gap - ContactRules.SLOP * (radii - diameter), diameter);
        if (!asleep) {
            double x = -meeting.normalX;
            double y = -meeting.normalY;
            double z = -meeting.normalZ;
            double back = -push(meeting, -gap, diameter);
            BodyStore.add(numbers, light, back, meeting.normalX, meeting.normalY, meeting.normalZ);
            // Only a light body that is pushed against the ground lifts the heavy one, not one pushed by its
            // neighbors.
            lift = push(meeting, Math.min(backing.sunk(light / BodyStore.STRIDE, x, y, z), -gap), diameter);
        }
        double weight = numbers[meeting.first + BodyStore.INVERSE_MASS];
        meeting.setBuilt(Math.abs(meeting.built()));
        resting.hold(meeting, weight, 0, weight, gap, lift);
        meeting.setBuilt(-meeting.built());
    }

    /** A body's displacement along the normal. */
    private double along(int body, SolvedContact meeting) {
        return numbers[body + BodyStore.MOVE] * meeting.normalX
                + numbers[body + BodyStore.MOVE + 1] * meeting.normalY
                + numbers[body + BodyStore.MOVE + 2] * meeting.normalZ;
    }

    private static double push(SolvedContact meeting, double overlap, double diameter) {
        return Math.max(
                0,
                Math.min(meeting.rules.pushShare() * (overlap - ContactRules.SLOP * diameter), MOST_PUSH * diameter));
    }

    /** Changes the light body's displacement along the normal. */
    private void changeMove(SolvedContact meeting, double length) {
        BodyStore.add(
                numbers, meeting.second + BodyStore.MOVE, length, meeting.normalX, meeting.normalY, meeting.normalZ);
    }
}
