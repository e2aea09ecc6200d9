/**
 * The benchmark: warm-up, measured frames, statistics, comparison of pictures, and reports. Depends on the engines, the
 * choice of the fastest one, the image package, the world, the scene, the physics and {@code files}.
 */
package dev.twister.bench;
