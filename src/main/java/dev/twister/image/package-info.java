/**
 * Finished pictures: their sizes, the frame an engine fills, and the PNG and Radiance HDR files made of it. Leans on
 * {@code files} alone.
 */
package dev.twister.image;
