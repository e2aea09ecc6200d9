/**
 * The living state between frames and its snapshot as the flat arrays that the kernel reads. Leans on the scene, the
 * sky, and the kernel's constants: its layout and the numbers of its tone maps.
 */
package dev.twister.world;
