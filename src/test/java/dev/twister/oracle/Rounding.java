package dev.twister.oracle;

/**
 * Effects of float rounding on a path after its view ray.
 *
 * @param lift outward offset of points on spheres, in radii
 * @param tilt added to the facet normals of rough surfaces
 * @param cut factor of the least throughput of a branch
 */
record Rounding(double lift, Vector tilt, double cut) {
    static final Rounding NONE = new Rounding(0, Vector.ZERO, 1);
}
