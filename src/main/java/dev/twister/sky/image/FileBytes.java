package dev.twister.sky.image;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.util.Optional;

/**
 * A file's bytes by their position, read through a window on the heap. The file is not mapped: where another process
 * shortens a mapped file, native and intrinsic code that reads it ends the JVM. Not for several threads at once.
 */
public final class FileBytes {
    private static final int WINDOW_BYTES = 1 << 16;

    private final Optional<FileChannel> channel;
    private final long length;
    private final byte[] window;
    private long windowStart;
    private int windowLength;

    public FileBytes(FileChannel channel) throws IOException {
        this.channel = Optional.of(channel);
        this.length = channel.size();
        window = new byte[WINDOW_BYTES];
    }

    /** Of a file whose bytes are at hand. */
    public FileBytes(byte[] bytes) {
        channel = Optional.empty();
        length = bytes.length;
        window = bytes;
        windowLength = bytes.length;
    }

    /** The length that the file had at first. */
    public long length() {
        return length;
    }

    /**
     * The byte at a position, 0 to 255.
     *
     * @param position 0 to {@code length() - 1}
     * @throws IOException where the file has become shorter
     */
    public int at(long position) throws IOException {
        return Byte.toUnsignedInt(window[place(position)]);
    }

    /** The four bytes from a position on, the highest first. */
    int intAt(long position) throws IOException {
        return at(position) << 24 | at(position + 1) << 16 | at(position + 2) << 8 | at(position + 3);
    }

    /** Copies the bytes from a position on, all of which must lie within the length. */
    public void copy(long position, byte[] target, int offset, int count) throws IOException {
        int done = 0;
        while (done < count) {
            int from = place(position + done);
            int step = Math.min(count - done, windowLength - from);
            System.arraycopy(window, from, target, offset + done, step);
            done += step;
        }
    }

    /** A copy of the bytes from a position on. */
    public byte[] copy(long position, int count) throws IOException {
        byte[] bytes = new byte[count];
        copy(position, bytes, 0, count);
        return bytes;
    }

    /** Whether the file starts with these characters, a byte each. */
    public boolean startsWith(String characters) throws IOException {
        if (length < characters.length()) {
            return false;
        }
        for (int i = 0; i < characters.length(); i++) {
            if (at(i) != characters.charAt(i)) {
                return false;
            }
        }
        return true;
    }

    /** Where in the window a byte is, once it is there. */
    private int place(long position) throws IOException {
        long place = position - windowStart;
        if (place >= 0 && place < windowLength) {
            return (int) place;
        }
        load(position);
        return 0;
    }

    private void load(long position) throws IOException {
        FileChannel from = channel.orElseThrow(FileChangedException::new);
        ByteBuffer target = ByteBuffer.wrap(window, 0, (int) Math.min(WINDOW_BYTES, length - position));
        while (target.hasRemaining()) {
            if (from.read(target, position + target.position()) < 0) {
                throw new FileChangedException();
            }
        }
        windowStart = position;
        windowLength = target.position();
    }

    /** A file that became shorter while it was read; a class of its own, as decoders wrap what their input throws. */
    static final class FileChangedException extends IOException {
        private static final long serialVersionUID = 1L;

        FileChangedException() {
            super("the file was changed while it was read; try again");
        }
    }

    /** A piece of a file as the stream that ImageIO wants. */
    static final class FileRange extends InputStream {
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

    /** A place in a file from which bytes are taken one after the other. */
    public static final class FileCursor {
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
}
