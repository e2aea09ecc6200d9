package dev.twister.oracle;

/** A sample of a pixel: a ray, and the numbers for what it meets. */
record ViewRay(Ray ray, SampleNumbers numbers) {
    ViewRay with(Ray moved) {
        return new ViewRay(moved, numbers);
    }
}
