package dev.twister.physics;

import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Pour;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/** Releases the spheres of a pour, each at its time, with a small random sideways velocity. */
final class PourRelease {
    /** Largest sideways speed relative to the spout's; without it, spheres would pile up in towers. */
    private static final double SPREAD = 0.04;

    private final double rate;
    private final double speed;
    private final List<Sphere> spheres;
    private final double[] sideways;
    private int out;

    private PourRelease(double rate, double speed, long seed, List<Sphere> spheres) {
        this.rate = rate;
        this.speed = speed;
        this.spheres = spheres;
        Random random = new Random(seed);
        sideways = new double[2 * spheres.size()];
        for (int i = 0; i < sideways.length; i++) {
            sideways[i] = speed * SPREAD * (2 * random.nextDouble() - 1);
        }
    }

    /** A spout for the spheres of a pour; without a pour it has none. */
    static PourRelease of(Optional<Pour> pour, List<Sphere> spheres) {
        return pour.map(known -> new PourRelease(known.rate(), known.speed(), known.seed(), spheres))
                .orElseGet(() -> new PourRelease(1, 0, 0, List.of()));
    }

    /**
     * Adds the spheres due between the times {@code now} and {@code end}, placed above the spout by the time until due.
     */
    void open(double now, double end, BodyStore bodies, VerletIntegrator integrator, Vector3 gravity) {
        while (out < spheres.size() && out / rate < end) {
            double early = out / rate - now;
            Sphere sphere = spheres.get(out);
            double vx = sideways[2 * out];
            double vz = sideways[2 * out + 1];
            Vector3 speeds = new Vector3(vx, -speed, vz);
            bodies.add(sphere.position().minus(speeds.times(early)), sphere.radius());
            bodies.setMove(
                    bodies.count - 1,
                    integrator.moveBefore(vx, gravity.x()),
                    integrator.moveBefore(-speed, gravity.y()),
                    integrator.moveBefore(vz, gravity.z()));
            out++;
        }
    }

    /** Adds the first {@code number} spheres at once, to be placed by the caller. */
    void skip(int number, BodyStore bodies) {
        for (Sphere sphere : spheres.subList(out, out + number)) {
            bodies.add(sphere.position(), sphere.radius());
        }
        out += number;
    }

    /** Whether more spheres will follow. */
    boolean isOpen() {
        return out < spheres.size();
    }
}
