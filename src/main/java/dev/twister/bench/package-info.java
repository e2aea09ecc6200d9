/**
 * The benchmark: warm-up, measured frames, statistics, comparison of pictures, and reports. Leans on the engines and
 * which of them is the fastest, the image package, the world, the scene, the physics and {@code files}; the commands
 * lean on it.
 */
package dev.twister.bench;
