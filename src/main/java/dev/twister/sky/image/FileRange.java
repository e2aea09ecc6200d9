package dev.twister.sky.image;

import java.io.IOException;
import java.io.InputStream;

/** A piece of a file as the stream that ImageIO wants. */
final class FileRange extends InputStream {
    private final FileBytes file;
    private final long end;
    private long position;

    /** The bytes from {@code start} on that lie before {@code end}. */
    FileRange(FileBytes file, long start, long end) {
        this.file = file;
        this.position = start;
        this.end = end;
    }

    @Override
    public int read() throws IOException {
        return position < end ? file.at(position++) : -1;
    }

    @Override
    public int read(byte[] target, int offset, int length) throws IOException {
        if (length == 0) {
            return 0;
        }
        if (position >= end) {
            return -1;
        }
        int count = (int) Math.min(length, end - position);
        file.copy(position, target, offset, count);
        position += count;
        return count;
    }
}
