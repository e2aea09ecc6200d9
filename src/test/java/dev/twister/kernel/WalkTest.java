package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.world.RandomCrowds;
import dev.twister.world.hierarchy.SphereHierarchy;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.ShrinkingMode;

/** Compares traversal of hierarchies with brute force, bit for bit. */
class WalkTest {
    private static final int RAYS = 300;
    private static final int SAMPLES = 6;

    @Provide
    Arbitrary<Long> seeds() {
        return Arbitraries.longs();
    }

    @Property(seed = "20261121", tries = 250, shrinking = ShrinkingMode.OFF)
    void hierarchyFindsWhatThePlainLoopFinds(@ForAll("seeds") long seed) {
        Random random = new Random(seed);
        RandomCrowds crowd = RandomCrowds.of(random, 1 + random.nextInt(400));
        int bodies = crowd.bodies();
        int materials = random.nextBoolean() ? Variant.MATERIALS : 0;
        float[] looks = looks(random, bodies, materials);
        float[] tree = SphereHierarchy.of(crowd.places(), bodies, new int[0], 1 + random.nextInt(8));
        float[] frame = Paths.frame(bodies);
        float[] scratch = new float[Layout.SCRATCH_LENGTH];
        for (int count = 0; count < RAYS; count++) {
            int leaving = random.nextInt(bodies + 1) - 1;
            float[] origin = origin(random, crowd, leaving);
            float[] direction = direction(random, crowd, origin);
            float[] path = Paths.ray(origin, direction, leaving);
            boolean transmits = leaving > 0 && looks[Layout.LOOK_STRIDE * leaving + Layout.LOOK_TRANSMISSION] > 0;
            path[Layout.INSIDE] = transmits && random.nextBoolean() ? 1 : 0;
            int expected = Hit.find(path, scratch, frame, tree, looks, new float[0], materials);
            float distance = path[Layout.DISTANCE];
            int actual = Hit.find(path, scratch, frame, tree, looks, new float[0], materials | Variant.WALK);
            assertThat(path[Layout.DISTANCE]).isEqualTo(distance);
            assertThat(actual).as("ray %d of seed %d", count, seed).isEqualTo(expected);
        }
    }

    @Property(seed = "20261121", tries = 250, shrinking = ShrinkingMode.OFF)
    void hierarchyShadesWhatThePlainLoopShades(@ForAll("seeds") long seed) {
        Random random = new Random(seed);
        RandomCrowds crowd = RandomCrowds.of(random, 1 + random.nextInt(400));
        int bodies = crowd.bodies();
        int materials = random.nextBoolean() ? Variant.MATERIALS : 0;
        float[] looks = looks(random, bodies, materials);
        float[] tree = SphereHierarchy.of(crowd.places(), bodies, new int[0], 1 + random.nextInt(8));
        float[] oneLeaf = SphereHierarchy.of(crowd.places(), bodies, new int[0], bodies);
        float[] scratch = new float[Layout.SCRATCH_LENGTH];
        float[] disc = new float[2 * SAMPLES];
        for (int sample = 0; sample < SAMPLES; sample++) {
            disc[2 * sample] = (float) (Math.sqrt((double) sample / SAMPLES) * Math.cos(2.4 * sample));
            disc[2 * sample + 1] = (float) (Math.sqrt((double) sample / SAMPLES) * Math.sin(2.4 * sample));
        }
        float[] frame = Paths.frame(bodies, disc);
        for (int count = 0; count < RAYS; count++) {
            int own = random.nextInt(bodies + 1) - 1;
            float[] point = origin(random, crowd, own);
            float[] axis = direction(random, crowd, point);
            float distance = (float) Math.pow(10, -1 + 3 * random.nextDouble());
            float discRadius = (float) (distance * Math.pow(10, -3 + 3 * random.nextDouble()));
            tree[Layout.PLACE_SIZE] = discRadius / 2;
            oneLeaf[Layout.PLACE_SIZE] = discRadius / 2;
            float[] path = Paths.lit(point, axis, distance);
            float walked =
                    Shadow.visible(path, own, scratch, frame, tree, looks, new float[0], materials | Variant.WALK);
            float plain = Shadow.visible(path, own, scratch, frame, oneLeaf, looks, new float[0], materials);
            // The factors are the same, but multiplied in another order.
            assertThat(walked)
                    .as("point %d of seed %d", count, seed)
                    .isCloseTo(plain, within(materials == 0 ? 0f : 1e-5f));
        }
    }

    /** With any materials allowed, half of the spheres transmit. */
    private static float[] looks(Random random, int bodies, int materials) {
        float[] looks = new float[Layout.LOOK_STRIDE * bodies];
        for (int body = Layout.FIRST_SPHERE; body < bodies && materials != 0; body++) {
            looks[Layout.LOOK_STRIDE * body + Layout.LOOK_TRANSMISSION] = Math.max(0, 2 * random.nextFloat() - 1);
        }
        return looks;
    }

    /** An origin on the body that the ray leaves, inside a sphere, among the spheres or far away. */
    private static float[] origin(Random random, RandomCrowds crowd, int leaving) {
        float[] away = direction(random);
        int body = leaving < Layout.FIRST_SPHERE ? Layout.LIGHT : leaving;
        double distance = switch (random.nextInt(4)) {
            case 0 -> 0.7 * crowd.radius(body);
            case 1 -> Math.pow(10, -2 + 7 * random.nextDouble());
            default -> crowd.radius(body);
        };
        float[] origin = new float[3];
        for (int axis = 0; axis < 3; axis++) {
            origin[axis] = (float) (crowd.center(body, axis) + distance * away[axis]);
        }
        return origin;
    }

    /** A direction at random, along an axis, or toward a body, often its very rim. */
    private static float[] direction(Random random, RandomCrowds crowd, float[] origin) {
        float[] direction = direction(random);
        int body = random.nextInt(crowd.bodies());
        int kind = random.nextInt(6);
        if (kind == 0) {
            direction = new float[3];
            direction[random.nextInt(3)] = random.nextBoolean() ? 1 : -1;
        } else if (kind > 1) {
            double[] to = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                to[axis] = crowd.center(body, axis)
                        + (kind == 2 ? 0 : crowd.radius(body) * direction[axis])
                        - (double) origin[axis];
            }
            double length = Math.sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
            for (int axis = 0; axis < 3 && length > 0; axis++) {
                direction[axis] = (float) (to[axis] / length);
            }
        }
        return direction;
    }

    private static float[] direction(Random random) {
        double x = random.nextGaussian();
        double y = random.nextGaussian();
        double z = random.nextGaussian();
        double length = Math.sqrt(x * x + y * y + z * z);
        return new float[] {(float) (x / length), (float) (y / length), (float) (z / length)};
    }
}
