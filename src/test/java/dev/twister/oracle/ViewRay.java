package dev.twister.oracle;

/** A pixel sample: a ray and the random numbers for its hits. */
record ViewRay(Ray ray, SampleNumbers numbers) {
    ViewRay with(Ray moved) {
        return new ViewRay(moved, numbers);
    }
}
