package dev.twister.image;

/**
 * One channel of an OpenEXR file.
 *
 * @param name such as {@code R} or {@code normal.R}, 1 to 31 characters of ASCII
 * @param values of all pixels, row by row from the top, among others
 * @param first where in the array the first pixel's is
 * @param stride from one pixel's to the next's, 1 or more
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record ExrChannel(String name, float[] values, int first, int stride) {}
