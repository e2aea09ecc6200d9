/**
 * Bodies that move: position Verlet in small steps, contacts solved by accumulated impulses, a grid for the pairs, all
 * on every core with the same bits whatever their number. Leans on the scene, which it starts from, on the world, which
 * it moves, on the kernel's layout constants, and on {@code threads}.
 */
package dev.twister.physics;
