package dev.twister.oracle;

import java.util.List;

/**
 * Where a ray starts.
 *
 * @param leaving the body that it leaves, or null for a view ray
 * @param inside whether it goes on inside that body
 * @param crossed whether it has crossed that body's surface
 */
record Departure(Body leaving, boolean inside, boolean crossed) {
    static final Departure CAMERA = new Departure(null, false, false);

    /** A body that a ray meets. */
    record Met(Body body, double distance) {}

    /** Returns the closest hit, with the lower index on a tie; its body is null if there is none. */
    Met closest(Ray ray, List<Body> bodies) {
        Met closest = new Met(null, Body.MISS);
        boolean after = false;
        for (Body body : bodies) {
            double distance = distance(body, ray, after);
            if (distance < closest.distance()) {
                closest = new Met(body, distance);
            }
            after |= isLeft(body);
        }
        return closest;
    }

    /**
     * Of spheres in one place, a ray that crosses meets one after the other.
     *
     * @param after whether the body comes after that which the ray leaves
     */
    private double distance(Body body, Ray ray, boolean after) {
        boolean twin = body instanceof SphereBody sphere && sphere.isTwinOf(leaving);
        boolean transmits = body.material().transmits();
        if (twin && crossed && after && (inside || transmits)) {
            return 0;
        }
        if (isLeft(body) || twin) {
            return inside && (transmits || !twin) ? body.distanceInside(ray) : Body.MISS;
        }
        return body.distance(ray);
    }

    @SuppressWarnings("ReferenceEquality") // compares identity of bodies
    private boolean isLeft(Body body) {
        return body == leaving;
    }
}
