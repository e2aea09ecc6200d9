package dev.twister.image;

import java.util.List;
import java.util.Optional;

/**
 * A picture in an OpenEXR file, or a part of one.
 *
 * @param width of the whole picture, in pixels
 * @param height of the whole picture
 * @param firstRow of the part, from the top
 * @param rows of the part
 * @param channels of the part's pixels, with different names, in any order
 */
public record ExrPicture(
        int width, int height, int firstRow, int rows, List<ExrChannel> channels, Optional<Provenance> provenance) {

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
}
