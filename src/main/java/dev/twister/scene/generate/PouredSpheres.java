package dev.twister.scene.generate;

import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** Places in a spout: points of Vogel's sunflower that keep spheres apart, taken in turn in a shuffled order. */
final class PouredSpheres {
    private PouredSpheres() {}

    /** How many spheres of the largest radius stand side by side in the spout's disc, at least 1. */
    static int places(Pour pour) {
        double rings = pour.width() / 2 / spacing(pour);
        return (int) Math.clamp(rings * rings, 1, pour.count());
    }

    static List<Sphere> of(Pour pour) {
        Random random = new Random(pour.seed());
        List<Integer> order = new ArrayList<>();
        for (int place = 0; place < places(pour); place++) {
            order.add(place);
        }
        Collections.shuffle(order, random);
        List<Sphere> spheres = new ArrayList<>(pour.count());
        for (int i = 0; i < pour.count(); i++) {
            spheres.add(sphere(pour, order.get(i % order.size()), (double) i / pour.count(), random));
        }
        return List.copyOf(spheres);
    }

    // Colors move along the palette as time goes on, so that layers of what was poured can be told apart.
    private static Sphere sphere(Pour pour, int place, double progress, Random random) {
        // Half a turn's start keeps the innermost points as far apart as the others.
        double outward = places(pour) == 1 ? 0 : spacing(pour) * StrictMath.sqrt(place + 0.5);
        double angle = place * SphereVortex.GOLDEN_ANGLE;
        Vector3 spout = pour.position();
        Vector3 position = new Vector3(
                spout.x() + outward * StrictMath.cos(angle), spout.y(), spout.z() + outward * StrictMath.sin(angle));
        double radius = pour.minRadius() + (pour.maxRadius() - pour.minRadius()) * random.nextDouble();
        Rgb color = pour.palette().at(progress * 0.8 + 0.2 * random.nextDouble());
        return Sphere.DEFAULT
                .withPosition(position)
                .withRadius(radius)
                .withMaterial(pour.material().withColor(color));
    }

    private static double spacing(Pour pour) {
        return pour.maxRadius() / SphereVortex.MAX_RADIUS_IN_SPACINGS;
    }
}
