/**
 * The living state between frames and its snapshot as the flat arrays that the kernel reads. Leans on the scene, the
 * sky, and the kernel's layout constants.
 */
package dev.twister.world;
