package dev.twister.sky;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** The ordinary image formats that a panorama may come in. */
enum OrdinaryImageFormat {
    PNG("\u0089PNG\r\n\u001a\n"),
    JPEG("\u00ff\u00d8\u00ff");

    /**
     * A block of 8 x 8 texels takes a bit at the very least, in progressive files; that is 512 texels a byte. Twice that is
     * allowed for good measure.
     */
    private static final long MOST_JPEG_TEXELS_PER_BYTE = 1024;

    /** The file's first bytes, a character each. */
    private final String magic;

    OrdinaryImageFormat(String magic) {
        this.magic = magic;
    }

    /** Whether the content starts as this format does. */
    boolean startsIn(ByteBuffer content) {
        byte[] bytes = magic.getBytes(StandardCharsets.ISO_8859_1);
        return content.remaining() >= bytes.length
                && content.slice(content.position(), bytes.length).equals(ByteBuffer.wrap(bytes));
    }

    /** Checks the file as far as that can be done before its decoder sees it. */
    void check(ByteBuffer content) throws IOException {
        if (this == PNG) {
            PngChunks.check(content);
        }
    }

    /** Checks that a file of this length can hold so many texels at all; a PNG's own check has seen to that. */
    void checkSize(long texels, long fileBytes) throws IOException {
        if (this == JPEG && texels > MOST_JPEG_TEXELS_PER_BYTE * fileBytes) {
            throw new IOException(texels + " texels cannot come from a JPEG of " + fileBytes + " bytes");
        }
    }
}
