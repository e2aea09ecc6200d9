package dev.twister.oracle;

import java.util.List;

/** The visible part of the light: each of the sunflower's points, and what the bodies in its way let pass. */
final class OracleShadow {
    private static final double GOLDEN_ANGLE_RADIANS = Math.PI * (3 - Math.sqrt(5));

    private final List<Body> bodies;
    private final SphereBody light;
    private final int samples;

    OracleShadow(List<Body> bodies, SphereBody light, int samples) {
        this.bodies = bodies;
        this.light = light;
        this.samples = samples;
    }

    /** S in [0, 1]. */
    double visible(Vector point, Body own) {
        Vector axis = light.center().minus(point).normalized();
        boolean alongX = axis.y() == 0 && axis.z() == 0;
        Vector discU =
                axis.cross(alongX ? new Vector(0, 1, 0) : new Vector(1, 0, 0)).normalized();
        Vector discW = discU.cross(axis);
        double visible = 0;
        for (int i = 0; i < samples; i++) {
            double r = 2 * light.radius() * Math.sqrt((double) i / samples);
            double theta = i * GOLDEN_ANGLE_RADIANS;
            Vector sample =
                    light.center().plus(discU.times(r * Math.cos(theta))).plus(discW.times(r * Math.sin(theta)));
            visible += passed(point, sample, own);
        }
        return visible / samples;
    }

    /** What part of the sample's light reaches the point past all bodies but its own. */
    @SuppressWarnings("ReferenceEquality") // which body it is, not what it is like: two may be alike in one place
    private double passed(Vector point, Vector sample, Body own) {
        Vector toSample = sample.minus(point);
        Ray shadowRay = new Ray(point, toSample.normalized());
        double distance = toSample.length();
        double passed = 1;
        for (Body body : bodies) {
            boolean meets = switch (body) {
                case PlaneBody plane -> plane.separates(point, sample);
                case SphereBody sphere -> sphere != light && sphere.distance(shadowRay) < distance;
            };
            if (meets && body != own) {
                passed *= body.material().transmission();
            }
        }
        return passed;
    }
}
