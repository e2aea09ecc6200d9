package dev.twister.sky.image;

import java.io.IOException;

/** A place in a file from which bytes are taken one after the other. */
public final class FileCursor {
    private final FileBytes file;
    private long position;

    public FileCursor(FileBytes file) {
        this(file, 0);
    }

    private FileCursor(FileBytes file, long position) {
        this.file = file;
        this.position = position;
    }

    /** Another cursor at the same place. */
    public FileCursor copy() {
        return new FileCursor(file, position);
    }

    public long position() {
        return position;
    }

    public long remaining() {
        return file.length() - position;
    }

    /** The next byte, 0 to 255; there must be one. */
    public int next() throws IOException {
        return file.at(position++);
    }

    /** Takes that number of bytes, which must be left. */
    public void next(byte[] target, int offset, int count) throws IOException {
        file.copy(position, target, offset, count);
        position += count;
    }
}
