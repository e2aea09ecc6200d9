package dev.twister.sky.image;

import java.io.IOException;

/** A file that became shorter while it was read; a class of its own, as decoders wrap what their input throws. */
final class FileChangedException extends IOException {
    private static final long serialVersionUID = 1L;

    FileChangedException() {
        super("the file was changed while it was read; try again");
    }
}
