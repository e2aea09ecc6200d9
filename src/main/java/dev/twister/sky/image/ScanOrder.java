package dev.twister.sky.image;

/**
 * In which of the eight orders a file stores the texels of the upright picture.
 *
 * @param width texels in a row of the upright picture
 * @param height rows of the upright picture
 * @param byColumns whether a scanline is a column of the picture and not a row
 * @param rightToLeft whether scanlines or their texels, whichever run along x, start at the right
 * @param bottomToTop whether scanlines or their texels, whichever run along y, start at the bottom
 */
public record ScanOrder(int width, int height, boolean byColumns, boolean rightToLeft, boolean bottomToTop) {
    /** The usual order: rows from the top, each from the left. */
    static ScanOrder upright(int width, int height) {
        return new ScanOrder(width, height, false, false, false);
    }

    /**
     * The order that an EXIF orientation stands for (EXIF 2.32, 4.6.4 A).
     *
     * @param orientation 1 to 8; anything else counts as 1, upright
     * @param storedWidth texels in a stored row
     * @param storedHeight stored rows
     */
    static ScanOrder ofExif(int orientation, int storedWidth, int storedHeight) {
        return switch (orientation) {
            case 2 -> new ScanOrder(storedWidth, storedHeight, false, true, false);
            case 3 -> new ScanOrder(storedWidth, storedHeight, false, true, true);
            case 4 -> new ScanOrder(storedWidth, storedHeight, false, false, true);
            case 5 -> new ScanOrder(storedHeight, storedWidth, true, false, false);
            case 6 -> new ScanOrder(storedHeight, storedWidth, true, true, false);
            case 7 -> new ScanOrder(storedHeight, storedWidth, true, true, true);
            case 8 -> new ScanOrder(storedHeight, storedWidth, true, false, true);
            default -> upright(storedWidth, storedHeight);
        };
    }

    public int scanlines() {
        return byColumns ? width : height;
    }

    public int scanlineLength() {
        return byColumns ? height : width;
    }

    /** The index, {@code y * width + x} of the upright picture, of a scanline's texel. */
    public int texel(int scanline, int place) {
        int x = byColumns ? scanline : place;
        int y = byColumns ? place : scanline;
        return (bottomToTop ? height - 1 - y : y) * width + (rightToLeft ? width - 1 - x : x);
    }

    /** The distance between the indices of neighbors in a scanline. */
    public int step() {
        if (byColumns) {
            return bottomToTop ? -width : width;
        }
        return rightToLeft ? -1 : 1;
    }
}
