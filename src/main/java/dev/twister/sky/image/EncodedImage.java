package dev.twister.sky.image;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;

/** An image file, looked through before it is decoded. */
interface EncodedImage {
    /** What its decoder is to read. */
    InputStream decodable();

    /** How its samples become RGB, if they are inks, which the decoder leaves as they are. */
    Optional<CmykColors> cmyk();

    /** What the file says of its samples. */
    ImageMeaning meaning();

    /**
     * Checks what could not be checked before its decoder said how large it is.
     *
     * @param texels in the whole image
     * @throws IOException where the file cannot hold that number, or would take minutes
     */
    void checkTexels(long texels) throws IOException;
}
