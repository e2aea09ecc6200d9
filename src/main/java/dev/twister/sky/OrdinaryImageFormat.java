package dev.twister.sky;

import java.io.IOException;
import java.util.function.Consumer;

/** The image formats that Java's own decoders read. */
enum OrdinaryImageFormat {
    PNG,
    JPEG;

    private static final String PNG_START = "\u0089PNG\r\n\u001a\n";
    private static final String JPEG_START = "\u00ff\u00d8\u00ff";

    /** Whether the content starts as this format does. */
    boolean startsIn(FileBytes file) throws IOException {
        return switch (this) {
            case PNG -> file.startsWith(PNG_START);
            case JPEG -> file.startsWith(JPEG_START);
        };
    }

    /**
     * Looks through a file of this format, and checks it as far as that can be done before its decoder sees it.
     *
     * @param warnings told of what the file says and is not used
     */
    EncodedImage open(FileBytes file, Consumer<String> warnings) throws IOException {
        return switch (this) {
            case PNG -> new PngFile(file, warnings);
            case JPEG -> new JpegFile(file, warnings);
        };
    }
}
