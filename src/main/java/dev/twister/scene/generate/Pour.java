package dev.twister.scene.generate;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.Copied;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/**
 * Spheres that come out of a round spout one after the other, at a steady rate: number i, from 0, at i / rate seconds.
 * Before that they are not there. Those that a file describes so need no line each.
 *
 * @param count how many, 1 or more
 * @param rate spheres a second, at most {@link #maxRate}
 * @param position the spout's center, in meters; the spheres' centers start in the level disc about it
 * @param width the disc's diameter, in meters
 * @param speed downwards at the spout, in m/s, above 0
 * @param minRadius of a sphere, in meters, above 0
 * @param maxRadius of a sphere, in meters; the radii are even between the two
 * @param palette the colors
 * @param material what the spheres are made of; their colors are the palette's
 * @param seed another one gives other places, radii and colors
 */
@Copied
public record Pour(
        int count,
        double rate,
        Vector3 position,
        double width,
        double speed,
        double minRadius,
        double maxRadius,
        Palette palette,
        Material material,
        int seed)
        implements PourCopy.With {
    /** One sphere of radius 0.1 m at the origin; to be changed by {@code with...} methods. */
    public static final Pour DEFAULT =
            new Pour(1, 1, Vector3.ZERO, 1, 1, 0.1, 0.1, Palette.DUSK, Material.DEFAULT.withReflectivity(8), 1);

    public Pour {
        requireNonNull(position, "position");
        requireNonNull(palette, "palette");
        requireNonNull(material, "material");
    }

    public double reflectivity() {
        return material.reflectivity();
    }

    /** The spheres in the order in which they come out, where they start: none that is out touches the next. */
    public List<Sphere> spheres() {
        return PouredSpheres.of(this);
    }

    /**
     * The most spheres a second that come out without touching: those that start at one place of the disc follow one
     * another by a diameter at the spout's speed.
     */
    public double maxRate() {
        return PouredSpheres.places(this) * speed / (2 * maxRadius);
    }

    public Pour withRadii(double newMinRadius, double newMaxRadius) {
        return new Pour(count, rate, position, width, speed, newMinRadius, newMaxRadius, palette, material, seed);
    }

    public Pour withReflectivity(double newReflectivity) {
        return withMaterial(material.withReflectivity(newReflectivity));
    }

    /** Places in a spout: points of Vogel's sunflower that keep spheres apart, taken in turn in a shuffled order. */
    private static final class PouredSpheres {
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
                    spout.x() + outward * StrictMath.cos(angle),
                    spout.y(),
                    spout.z() + outward * StrictMath.sin(angle));
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
}
