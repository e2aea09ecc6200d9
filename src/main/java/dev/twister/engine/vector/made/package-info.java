/**
 * The kernel's path tracing in lanes. {@link dev.twister.engine.vector.made.PathColumns} is written by hand; the
 * classes that work on it are made from {@link dev.twister.kernel.PathTracer} by {@code dev.twister.lanes} (in
 * {@code src/lanes}) at each build.
 */
package dev.twister.engine.vector.made;
