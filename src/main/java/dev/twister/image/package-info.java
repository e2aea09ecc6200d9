/**
 * Pictures: sizes, the frame that an engine fills, PNG, Radiance HDR and OpenEXR files with their provenance, and
 * joining from parts. Depends on {@code files} alone.
 */
package dev.twister.image;
