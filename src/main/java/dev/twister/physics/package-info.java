/**
 * Moving bodies: position Verlet in small steps, contacts solved by accumulated impulses, and a grid for the broad
 * phase. It runs on all cores with bitwise identical results for any number of them. Depends on the scene, the world,
 * the kernel's layout constants, and {@code threads}.
 */
package dev.twister.physics;
