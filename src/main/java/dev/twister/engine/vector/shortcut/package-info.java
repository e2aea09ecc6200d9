/**
 * Optional optimizations that leave the picture as it is, rounding aside. Each is a
 * {@link dev.twister.engine.vector.frame.Shortcut} that tests can disable. Whether one applies is decided in one place:
 * {@code Choices} for tiles and the rays of a bounce, {@code TileSky} for the sky, {@code ShadowFrame} and
 * {@code ShadowRange} for shadows. Methods whose first parameter is a tile or its columns are compiled separately
 * ({@code StageInlining}).
 */
package dev.twister.engine.vector.shortcut;
