/**
 * The mutable state between frames, and its snapshots as the flat arrays that the kernel reads. Depends on the scene,
 * the sky and the kernel's constants: its layout and the numbers of its tone maps.
 */
package dev.twister.world;
