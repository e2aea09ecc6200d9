package dev.twister.physics;

import java.util.function.Consumer;

/**
 * Balances the contact loads of bodies that have just woken. While a body sleeps, moving bodies press it harder and
 * harder without moving it, and loads between sleeping bodies are not stored. Continuing with these loads would eject a
 * small body below a heavy one, or lift the heavy one: energy from nothing. Therefore, before anything moves, the
 * contacts of woken bodies are solved several times on their own, starting with all known loads, until they carry what
 * rests on them.
 */
final class LoadBalancing {
    /**
     * Number of sweeps. Contacts with large mass ratios converge slowly; 10 sweeps leave some bodies out of balance.
     */
    private static final int SWEEPS = 20;

    private final BodyStore bodies;
    private final ContactSolver solver;

    LoadBalancing(BodyStore bodies, Surroundings surroundings) {
        this.bodies = bodies;
        solver = ContactSolver.bracing(bodies, surroundings);
    }

    /** Sets the length of the sub-steps, in seconds. */
    void setSubstep(double seconds) {
        solver.setSubstep(seconds);
    }

    /** Gives woken bodies the known loads; called before the moves of a sub-step are computed. */
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

    /** Balances the loads; called after the moves are computed and before the first contacts are solved. */
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
            // The sub-step itself computes what warm-starts the next one.
            bodies.clearSupport(body);
            bodies.setBraced(body);
        }
    }
}
