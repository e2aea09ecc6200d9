/**
 * Motion files: the places of a scene's bodies, simulated once, and read by frame number; and point caches made of
 * them. Leans on the scene, on the world, which it moves, and on {@code files}.
 */
package dev.twister.motion;
