package dev.twister.exr;

/** How chunks are compressed, in the order of the format's numbers, and how many rows a chunk has. */
enum ExrCompression {
    NONE(1, true),
    RLE(1, true),
    ZIPS(1, true),
    ZIP(16, true),
    PIZ(32, true),
    PXR24(16, true),
    B44(32, true),
    B44A(32, true),
    DWAA(32, false),
    DWAB(256, false);

    private final int rows;
    private final boolean read;

    ExrCompression(int rows, boolean read) {
        this.rows = rows;
        this.read = read;
    }

    int rows() {
        return rows;
    }

    /** Whether there is a decoder for it here. */
    boolean isRead() {
        return read;
    }
}
