package dev.twister.sky;

import java.io.IOException;

/** A place in a file from which bytes are taken one after the other. */
final class FileCursor {
    private final FileBytes file;
    private long position;

    FileCursor(FileBytes file) {
        this(file, 0);
    }

    private FileCursor(FileBytes file, long position) {
        this.file = file;
        this.position = position;
    }

    /** Another cursor at the same place. */
    FileCursor copy() {
        return new FileCursor(file, position);
    }

    long position() {
        return position;
    }

    long remaining() {
        return file.length() - position;
    }

    /** The next byte, 0 to 255; there must be one. */
    int next() throws IOException {
        return file.at(position++);
    }

    /** Takes that number of bytes, which must be left. */
    void next(byte[] target, int offset, int count) throws IOException {
        file.copy(position, target, offset, count);
        position += count;
    }
}
