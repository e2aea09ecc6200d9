package dev.twister.exr;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;

/** A file's bytes by their position. */
public interface ExrBytes {
    /** Bytes in the file. */
    long length();

    /**
     * Copies bytes, all of which must lie within the length.
     *
     * @param position of the first
     */
    void copy(long position, byte[] target) throws IOException;

    /** The bytes of an open file, as long as it is now. */
    static ExrBytes of(FileChannel file) throws IOException {
        long length = file.size();
        return new ExrBytes() {
            @Override
            public long length() {
                return length;
            }

            @Override
            public void copy(long position, byte[] target) throws IOException {
                ByteBuffer bytes = ByteBuffer.wrap(target);
                while (bytes.hasRemaining()) {
                    if (file.read(bytes, position + bytes.position()) < 0) {
                        throw new EOFException();
                    }
                }
            }
        };
    }

    /**
     * Some bytes, for numbers with the lowest byte first.
     *
     * @throws EOFException if the file ends before them
     */
    default ByteBuffer read(long position, int count) throws IOException {
        if (position < 0 || position > length() - count) {
            throw new EOFException();
        }
        byte[] bytes = new byte[count];
        copy(position, bytes);
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }
}
