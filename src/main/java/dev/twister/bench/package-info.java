/**
 * The benchmark: warm-up, measured frames, statistics, comparison of pictures, and reports; and which engine is the
 * fastest. Leans on the engines, the image package, the world, the scene, the physics and {@code files}; the commands and
 * the window lean on it.
 */
package dev.twister.bench;
