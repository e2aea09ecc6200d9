package dev.twister.physics;

import java.util.function.Consumer;

/**
 * Puts the loads of the contacts of bodies that have just woken in balance. While a body slept, what moves pressed it
 * ever harder and nothing asked what it rests on; the loads among those that slept were not kept at all. To go on with
 * such loads would shoot a small body that lies under a heavy one away, or lift the heavy one: energy out of nothing.
 * So, before anything moves, the contacts of what has woken are solved alone and several times, with what all loads
 * that are known give, until what holds them carries what presses them.
 */
final class Bracing {
    /**
     * Small bodies and heavy ones in one contact are slow to find their loads; 10 sweeps leave some bodies out of
     * balance.
     */
    private static final int SWEEPS = 20;

    private final BodyStore bodies;
    private final ContactSolver solver;

    Bracing(BodyStore bodies, Surroundings surroundings) {
        this.bodies = bodies;
        solver = ContactSolver.bracing(bodies, surroundings);
    }

    /** Says how long the sub-steps are from now on, in seconds. */
    void setSubstep(double seconds) {
        solver.setSubstep(seconds);
    }

    /** Before the bodies get their moves: lets what has just woken start with the loads that are known. */
    void load(ContactSearch search) {
        each(search, contacts -> {
            for (int index = 0; index < contacts.unbalancedCount; index++) {
                int contact = contacts.unbalanced[index];
                clear(contacts.first[contact]);
                clear(contacts.second[contact]);
            }
        });
        each(search, contacts -> {
            for (int index = 0; index < contacts.unbalancedCount; index++) {
                int contact = contacts.unbalanced[index];
                int first = contacts.first[contact];
                int second = contacts.second[contact];
                boolean firm = contacts.impulses[Contacts.IMPULSES * contact + Contacts.BUILT] < 0;
                if (!firm || isHeavier(first, second)) {
                    load(first, contacts.impulses, contact, 1);
                }
                if (!firm || isHeavier(second, first)) {
                    load(second, contacts.impulses, contact, -1);
                }
            }
        });
    }

    /** When they have them, and no contact of the sub-step is solved yet. */
    void brace(ContactSearch search) {
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            each(search, solver::solveUnbalanced);
        }
        each(search, contacts -> {
            for (int index = 0; index < contacts.unbalancedCount; index++) {
                int contact = contacts.unbalanced[index];
                end(contacts.first[contact]);
                end(contacts.second[contact]);
            }
        });
    }

    private static void each(ContactSearch search, Consumer<Contacts> work) {
        for (int list = 0; list < search.lists(); list++) {
            work.accept(search.contacts(list));
        }
    }

    private boolean isHeavier(int body, int other) {
        double[] n = bodies.numbers;
        return n[BodyStore.STRIDE * body + BodyStore.RADIUS] > n[BodyStore.STRIDE * other + BodyStore.RADIUS];
    }

    private void clear(int body) {
        if (body >= 0 && bodies.isJustWoken(body)) {
            bodies.clearSupport(body);
        }
    }

    private void load(int body, double[] impulses, int contact, double sign) {
        if (body >= 0 && bodies.isJustWoken(body)) {
            int at = BodyStore.STRIDE * body;
            double weight = sign * bodies.numbers[at + BodyStore.INVERSE_MASS];
            for (int axis = 0; axis < 3; axis++) {
                bodies.numbers[at + BodyStore.SUPPORT + axis] += weight * impulses[Contacts.IMPULSES * contact + axis];
            }
        }
    }

    private void end(int body) {
        if (body >= 0) {
            // The sub-step itself finds what the next one starts with.
            bodies.clearSupport(body);
            bodies.setBraced(body);
        }
    }
}
