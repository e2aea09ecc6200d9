package dev.twister.oracle;

import java.util.List;

/** The visible part of the light: each of the sunflower's points, and each sphere, or the plane, in its way. */
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
        int blocked = 0;
        for (int i = 0; i < samples; i++) {
            double r = 2 * light.radius() * Math.sqrt((double) i / samples);
            double theta = i * GOLDEN_ANGLE_RADIANS;
            Vector sample =
                    light.center().plus(discU.times(r * Math.cos(theta))).plus(discW.times(r * Math.sin(theta)));
            if (isBlocked(point, sample, own)) {
                blocked++;
            }
        }
        return 1 - (double) blocked / samples;
    }

    @SuppressWarnings("ReferenceEquality") // which body it is, not what it is like: two may be alike in one place
    private boolean isBlocked(Vector point, Vector sample, Body own) {
        Vector toSample = sample.minus(point);
        Ray shadowRay = new Ray(point, toSample.normalized());
        double distance = toSample.length();
        for (Body body : bodies) {
            boolean blocks = switch (body) {
                case PlaneBody plane -> plane.separates(point, sample);
                case SphereBody sphere -> sphere != light && sphere.distance(shadowRay) < distance;
            };
            if (blocks && body != own) {
                return true;
            }
        }
        return false;
    }
}
