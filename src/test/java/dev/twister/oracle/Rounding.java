package dev.twister.oracle;

/**
 * What the rounding of floats may do to a path after its view ray.
 *
 * @param lift how far outward points of spheres are, in radii
 * @param tilt what is added to the normals of rough surfaces' facets
 * @param cut what the least throughput of a branch is multiplied by
 */
record Rounding(double lift, Vector tilt, double cut) {
    static final Rounding NONE = new Rounding(0, Vector.ZERO, 1);
}
