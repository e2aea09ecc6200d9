package dev.twister.denoise;

/**
 * Three floats per pixel within an array, row by row from the top.
 *
 * @param first index of the first pixel's first value
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record Plane(float[] values, int first) {}
