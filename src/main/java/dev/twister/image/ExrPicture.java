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
        int width, int height, int firstRow, int rows, List<ExrChannel> channels, Optional<Provenance> provenance) {}
