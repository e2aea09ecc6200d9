package dev.twister.physics;

/** Contact of two bodies: an impact, a resting contact, or the contact of a heavy body with a firm light one. */
final class PairContact {
    /** Relative to the pair's radii: centers closer than this count as coincident. */
    private static final double COINCIDENT = 1e-9;

    /** Ratio of the radii from which the lighter body yields to the heavier one only if nothing holds it. */
    private static final double UNEQUAL_RADII = 3;

    private final double[] numbers;
    private final Waking waking;
    private final Impact impact;
    private final RestingContact resting;
    private final FirmContact firm;

    PairContact(BodyStore bodies, Surroundings surroundings) {
        numbers = bodies.numbers;
        waking = new Waking(bodies);
        impact = new Impact(bodies);
        resting = new RestingContact(bodies);
        firm = new FirmContact(bodies, surroundings);
    }

    /**
     * Solves the contact of two bodies.
     *
     * @param at start of the contact's impulses
     */
    void solve(SolvedContact meeting, int at, int one, int two) {
        int a = BodyStore.STRIDE * one;
        int b = BodyStore.STRIDE * two;
        double[] n = numbers;
        double px = n[a] - n[b];
        double py = n[a + 1] - n[b + 1];
        double pz = n[a + 2] - n[b + 2];
        double radii = n[a + BodyStore.RADIUS] + n[b + BodyStore.RADIUS];
        double square = px * px + py * py + pz * pz;
        double outside = square - radii * radii;
        double ofLighter = Math.max(n[a + BodyStore.INVERSE_MASS], n[b + BodyStore.INVERSE_MASS]);
        if (n[a + BodyStore.INVERSE_MASS] == 0 || n[b + BodyStore.INVERSE_MASS] == 0) {
            waking.wake(one, two, square, radii, meeting.rules.wakeSpeedSquared());
            // A sleeping body too must not carry more than it could bear awake.
            ofLighter = Math.max(waking.inverseMassAwake(one), waking.inverseMassAwake(two));
        }
        double dx = n[a + BodyStore.MOVE] - n[b + BodyStore.MOVE];
        double dy = n[a + BodyStore.MOVE + 1] - n[b + BodyStore.MOVE + 1];
        double dz = n[a + BodyStore.MOVE + 2] - n[b + BodyStore.MOVE + 2];
        double closing = px * dx + py * dy + pz * dz;
        boolean loaded = meeting.impulses[at + Contacts.BUILT] != 0;
        if (outside > 0 && !loaded && Impact.missed(outside, closing, dx * dx + dy * dy + dz * dz)) {
            return;
        }
        double firstWeight = n[a + BodyStore.INVERSE_MASS];
        double secondWeight = n[b + BodyStore.INVERSE_MASS];
        if (firstWeight + secondWeight == 0) {
            return;
        }
        meeting.at = at;
        meeting.first = a;
        meeting.second = b;
        meeting.setMove(dx, dy, dz);
        double distance = Math.sqrt(square);
        if (distance > COINCIDENT * radii) {
            double inverse = 1 / distance;
            meeting.setNormal(px * inverse, py * inverse, pz * inverse);
            if (isUnequal(a, b) && firm.solve(meeting, distance, radii, outside)) {
                return;
            }
            // Displacement by warm-started loads is not an impact: the other contacts of the body take it back.
            if (!loaded && -closing * inverse > meeting.rules.impactSpeed() + carried(a) + carried(b)) {
                meeting.setPlace(px, py, pz, outside, closing);
                if (impact.resolve(meeting, false)) {
                    return;
                }
            }
        } else {
            // Any direction will do; it depends on the bodies' numbers, so that many bodies at one point spread.
            int axis = (one + two) % 3;
            meeting.setNormal(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
        }
        double gap = distance - radii;
        double share = meeting.rules.pushShare() * (-gap - ContactRules.SLOP * radii);
        double push = Math.max(0, Math.min(share, 2 * FirmContact.MOST_PUSH * Math.min(radius(a), radius(b))));
        resting.hold(meeting, firstWeight, secondWeight, ofLighter, gap, push);
    }

    private boolean isUnequal(int a, int b) {
        return Math.max(radius(a), radius(b)) > UNEQUAL_RADII * Math.min(radius(a), radius(b));
    }

    private double radius(int at) {
        return numbers[at + BodyStore.RADIUS];
    }

    private double carried(int at) {
        return numbers[at + BodyStore.CARRIED];
    }
}
