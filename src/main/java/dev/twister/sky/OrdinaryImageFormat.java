package dev.twister.sky;

import java.io.IOException;
import java.util.function.Consumer;

/** The ordinary image formats that a panorama may come in. */
enum OrdinaryImageFormat {
    PNG("\u0089PNG\r\n\u001a\n"),
    JPEG("\u00ff\u00d8\u00ff");

    /** The file's first bytes, a character each. */
    private final String magic;

    OrdinaryImageFormat(String magic) {
        this.magic = magic;
    }

    /** Whether the content starts as this format does. */
    boolean startsIn(FileBytes file) throws IOException {
        return file.startsWith(magic);
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
