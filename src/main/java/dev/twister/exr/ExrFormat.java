package dev.twister.exr;

/** A channel's numbers, in the order of the format's numbers. */
enum ExrFormat {
    UINT(4),
    HALF(2),
    FLOAT(4);

    private final int bytes;

    ExrFormat(int bytes) {
        this.bytes = bytes;
    }

    int bytes() {
        return bytes;
    }
}
