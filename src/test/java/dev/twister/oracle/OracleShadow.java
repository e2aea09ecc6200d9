package dev.twister.oracle;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** The visible part of a light over the points of the sunflower pattern, with transmitting occluders. */
final class OracleShadow {
    private static final double GOLDEN_ANGLE_RADIANS = Math.PI * (3 - Math.sqrt(5));

    private final List<Body> bodies;
    private final int samples;

    /** @param bodies those that cast shadows, which lights do not */
    OracleShadow(List<Body> bodies, int samples) {
        this.bodies = bodies;
        this.samples = samples;
    }

    /** Returns a light's visibility in [0, 1] at a hit point. */
    double visible(SphereBody light, Vector point, Body own, Ray ray) {
        Vector axis = light.center().minus(point).normalized();
        if (own instanceof TriangleBody triangle && triangle.facing(ray).dot(axis) <= 0) {
            return 0;
        }
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

    /** Returns the fraction of the sample's light that passes all bodies other than the point's own. */
    @SuppressWarnings("ReferenceEquality") // identity: two bodies may be equal at the same place
    private double passed(Vector point, Vector sample, Body own) {
        Vector toSample = sample.minus(point);
        Ray shadowRay = new Ray(point, toSample.normalized());
        double distance = toSample.length();
        double passed = 1;
        Set<Integer> metMeshes = new HashSet<>();
        for (Body body : bodies) {
            boolean meets = switch (body) {
                case PlaneBody plane -> plane.separates(point, sample);
                case SphereBody sphere -> sphere.distance(shadowRay) < distance && !sphere.isTwinOf(own);
                case TriangleBody triangle -> triangle.distance(shadowRay) < distance;
            };
            if (meets
                    && body instanceof TriangleBody triangle
                    && triangle.maps().blends()
                    && body != own) {
                passed *= 1 - triangle.opacity(shadowRay.at(triangle.distance(shadowRay)));
            } else if (meets && body != own && (!(body instanceof TriangleBody mesh) || metMeshes.add(mesh.number()))) {
                passed *= body.material().transmission();
            }
        }
        return passed;
    }
}
