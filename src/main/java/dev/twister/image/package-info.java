/**
 * Finished pictures: their sizes, the frame an engine fills, the PNG, Radiance HDR and OpenEXR files made of it, what
 * those say of how they were made, and pictures joined from parts. Leans on {@code files} alone.
 */
package dev.twister.image;
