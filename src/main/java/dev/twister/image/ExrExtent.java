package dev.twister.image;

import java.util.Comparator;
import java.util.List;

/**
 * Where the rows of an OpenEXR file are in a picture.
 *
 * @param width of the whole picture, in pixels
 * @param height of the whole picture
 * @param firstRow of the file, from the top
 * @param rows of the file
 */
public record ExrExtent(int width, int height, int firstRow, int rows) {
    /** The first row of a picture, from the top, that none of these files has. */
    static int missingRow(List<ExrExtent> files) {
        int covered = 0;
        for (ExrExtent file : files.stream()
                .sorted(Comparator.comparingInt(ExrExtent::firstRow))
                .toList()) {
            if (file.firstRow <= covered) {
                covered = Math.max(covered, file.firstRow + file.rows);
            }
        }
        return covered;
    }
}
