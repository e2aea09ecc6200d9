package dev.twister.oracle;

import dev.twister.scene.light.LightShape;

/** A sphere, or a light, whose color is a radiance, and whose shape says against which rays it has it. */
record SphereBody(Vector center, double radius, OracleMaterial material, LightShape shape) implements Body {
    SphereBody(Vector center, double radius, OracleMaterial material) {
        this(center, radius, material, LightShape.SPHERE);
    }

    /**
     * Returns the near root of {@code |origin + t direction - center|^2 = radius^2} if positive, else the far root if
     * that is positive and the sphere transmits. Rays against which a spot emits nothing pass it.
     */
    @Override
    public double distance(Ray ray) {
        if (part(ray.direction()) == 0) {
            return MISS;
        }
        double near = root(ray, -1);
        return near > 0 || !material.transmits() ? inFront(near) : distanceInside(ray);
    }

    /** The part of the light of glTF's spots that goes against a direction. */
    @Override
    public double part(Vector direction) {
        if (shape.kind() != LightShape.Kind.SPOT) {
            return 1;
        }
        double outer = Math.cos(Math.toRadians(shape.coneAngleDegrees() / 2));
        double inner = Math.cos(Math.toRadians(shape.coneAngleDegrees() / 2 * (1 - shape.coneBlend())));
        double cosine = direction.dot(OracleTracer.vector(shape.toward()));
        return Math.pow(Math.clamp((cosine - outer) / Math.max(0.001, inner - outer), 0, 1), 2);
    }

    @Override
    public double distanceInside(Ray ray) {
        return inFront(root(ray, 1));
    }

    /** Whether another body is a sphere in the same place. */
    @SuppressWarnings("ReferenceEquality") // compares identity of bodies
    boolean isTwinOf(Body other) {
        return other != null
                && other != this
                && other instanceof SphereBody(Vector otherCenter, double otherRadius, OracleMaterial _, LightShape _)
                && center.equals(otherCenter)
                && radius == otherRadius;
    }

    private static double inFront(double root) {
        return root > 0 ? root : MISS;
    }

    /** Returns the near root for -1, the far root for 1, or NaN if there is none. */
    private double root(Ray ray, int side) {
        Vector fromCenter = ray.origin().minus(center);
        double halfB = fromCenter.dot(ray.direction());
        double c = fromCenter.dot(fromCenter) - radius * radius;
        return -halfB + side * Math.sqrt(halfB * halfB - c);
    }

    @Override
    public Vector normal(Vector point) {
        return point.minus(center).normalized();
    }

    @Override
    public boolean isMetFromInside(Ray ray, Vector normal) {
        return material.transmits() && ray.direction().dot(normal) > 0;
    }

    @Override
    public Color albedo(Vector point) {
        Vector normal = normal(point);
        double u = 0.5 + Math.atan2(normal.x(), -normal.z()) / (2 * Math.PI);
        double v = 0.5 - Math.asin(Math.clamp(normal.y(), -1, 1)) / Math.PI;
        return material.texturedToPoles(material.color(), u, v);
    }
}
