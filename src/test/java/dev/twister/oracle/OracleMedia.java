package dev.twister.oracle;

import java.util.List;

/**
 * The transmitting bodies that a ray is in: the one that it has entered last, and the one around that; null for none.
 */
record OracleMedia(Body inner, Body outer) {
    static final OracleMedia NONE = new OracleMedia(null, null);

    /** Returns those around a camera, of which the smallest is the inner one. Spheres alone. */
    static OracleMedia around(Vector camera, List<Body> bodies) {
        OracleMedia media = NONE;
        List<SphereBody> around = bodies.stream()
                .filter(OracleMedia::isMedium)
                .filter(SphereBody.class::isInstance)
                .map(SphereBody.class::cast)
                .filter(sphere -> sphere.center().minus(camera).length() < sphere.radius())
                .sorted((a, b) -> Double.compare(b.radius(), a.radius()))
                .toList();
        for (SphereBody sphere : around) {
            media = media.enter(sphere);
        }
        return media;
    }

    /** Returns those of a ray that has reached a body. */
    OracleMedia at(Body body, boolean fromInside) {
        return fromInside && !isSame(body, inner) && !isSame(body, outer) ? enter(body) : this;
    }

    OracleMedia cross(Body body, boolean into) {
        return into ? enter(body) : leave(body);
    }

    private static boolean isMedium(Body body) {
        return body.material().transmits() && !body.material().thin();
    }

    private OracleMedia enter(Body body) {
        return isSame(body, inner) || !isMedium(body) ? this : new OracleMedia(body, inner);
    }

    private OracleMedia leave(Body body) {
        if (isSame(body, inner)) {
            return new OracleMedia(outer, null);
        }
        return isSame(body, outer) ? new OracleMedia(inner, null) : this;
    }

    /** What is left of white light after a distance. */
    Color passed(double distance) {
        return inner == null ? new Color(1, 1, 1) : inner.material().passed(distance);
    }

    /** What a body's radiance inside is outside, where its rays are spread. */
    double spread() {
        double index = index(inner) * index(outer);
        return 1 / (index * index);
    }

    private static double index(Body body) {
        return body == null ? 1 : body.material().ior();
    }

    @SuppressWarnings("ReferenceEquality") // compares identity of bodies
    private static boolean isSame(Body body, Body other) {
        return body instanceof TriangleBody triangle
                ? other instanceof TriangleBody second && triangle.number() == second.number()
                : body == other;
    }
}
