/**
 * What makes frames faster and leaves them as they are, rounding aside: each a
 * {@link dev.twister.engine.vector.frame.Shortcut}, which tests switch off. Whether one applies is asked in one place:
 * {@code Choices} for tiles and the rays of a bounce, {@code TileSky} for the sky, {@code ShadowFrame} and
 * {@code ShadowRange} for shadows. What has columns as its first parameter is compiled by itself
 * ({@code StageInlining}).
 */
package dev.twister.engine.vector.shortcut;
