package dev.twister.image;

/**
 * One channel of an OpenEXR file.
 *
 * @param name such as {@code R} or {@code normal.R}, 1 to 31 characters of ASCII
 * @param values array with the values of all pixels, row by row from the top
 * @param first index of the first pixel's value
 * @param stride distance between the values of neighbors in a row, 1 or more
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record ExrChannel(String name, float[] values, int first, int stride) {}
