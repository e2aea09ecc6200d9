/**
 * Motion files: the positions of a scene's bodies, simulated once and read by frame number; and point caches made from
 * them. Depends on the scene, the world and {@code files}.
 */
package dev.twister.motion;
