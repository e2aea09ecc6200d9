/**
 * Twister as a library: {@link dev.twister.Twister} renders a scene file, or a scene that
 * {@link dev.twister.SceneBuilder} makes in code. For animations, other engines and linear radiance, use
 * {@link dev.twister.world.World} and {@link dev.twister.engine.Engine}.
 */
package dev.twister;
