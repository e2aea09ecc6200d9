package dev.twister.denoise;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;

/** Numbers and texts between this process and the one that denoises. Used by one thread at a time. */
final class FloatChannel implements AutoCloseable {
    private static final int BYTES = 1 << 20;

    private final SocketChannel socket;
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(BYTES).order(ByteOrder.nativeOrder());

    /** @param socket connected; closed with this object */
    FloatChannel(SocketChannel socket) {
        this.socket = socket;
    }

    void writeInts(int... values) throws IOException {
        buffer.clear();
        for (int value : values) {
            buffer.putInt(value);
        }
        write(buffer.flip());
    }

    void writeText(String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        int length = Math.min(bytes.length, BYTES);
        writeInts(length);
        write(ByteBuffer.wrap(bytes, 0, length));
    }

    /** Writes all remaining values; those that are not finite as 0. */
    void writeFinite(FloatBuffer values) throws IOException {
        while (values.hasRemaining()) {
            buffer.clear();
            while (buffer.hasRemaining() && values.hasRemaining()) {
                float value = values.get();
                buffer.putFloat(Float.isFinite(value) ? value : 0);
            }
            write(buffer.flip());
        }
    }

    /** Writes all remaining bytes. */
    void write(ByteBuffer bytes) throws IOException {
        while (bytes.hasRemaining()) {
            socket.write(bytes);
        }
    }

    int readInt() throws IOException {
        return read(Integer.BYTES).getInt();
    }

    String readText() throws IOException {
        return StandardCharsets.UTF_8.decode(read(readInt())).toString();
    }

    /** Fills what remains of the values. */
    void read(FloatBuffer values) throws IOException {
        while (values.hasRemaining()) {
            int count = Math.min(values.remaining(), BYTES / Float.BYTES);
            values.put(read(count * Float.BYTES).asFloatBuffer());
        }
    }

    /** Fills what remains of the bytes. */
    void read(ByteBuffer bytes) throws IOException {
        while (bytes.hasRemaining()) {
            if (socket.read(bytes) < 0) {
                throw new EOFException();
            }
        }
    }

    private ByteBuffer read(int bytes) throws IOException {
        read(buffer.clear().limit(bytes));
        return buffer.flip();
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
