package dev.twister.mesh.input;

import dev.twister.mesh.MeshException;
import java.io.IOException;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;

/**
 * Random access to the bytes of a file, through a window on the heap, or of an array. Files are not memory-mapped,
 * because the JVM may crash if another process truncates a mapped file. Not thread-safe.
 */
public final class Bytes {
    private static final int WINDOW_BYTES = 1 << 16;
    private static final VarHandle SHORTS =
            MethodHandles.byteArrayViewVarHandle(short[].class, ByteOrder.LITTLE_ENDIAN);
    private static final VarHandle INTS = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    private static final VarHandle LONGS = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

    private interface Source {
        int read(ByteBuffer target, long position) throws IOException;
    }

    private final String name;
    private final Source source;
    private final long length;
    private final byte[] window;
    private long windowStart;
    private int windowLength;

    private Bytes(String name, Source source, long length, byte[] window, int windowLength) {
        this.name = name;
        this.source = source;
        this.length = length;
        this.window = window;
        this.windowLength = windowLength;
    }

    /** The bytes of a file with its current length. */
    public static Bytes of(Path file, FileChannel channel) throws IOException {
        return new Bytes(QuotedText.path(file), channel::read, channel.size(), new byte[WINDOW_BYTES], 0);
    }

    /** The bytes of an array; messages use the given name. */
    public static Bytes of(String name, byte[] array) {
        return new Bytes(name, (_, _) -> -1, array.length, array, array.length);
    }

    public long length() {
        return length;
    }

    public String name() {
        return name;
    }

    /** An exception for a problem at a position. */
    public MeshException failure(long position, String problem) {
        return new MeshException(name + ": byte " + position + ": " + problem);
    }

    /** An exception for a problem with the file as a whole. */
    public MeshException failure(String problem) {
        return new MeshException(name + ": " + problem);
    }

    /** Checks that a number of bytes follows a position. */
    public void require(long position, long count, String what) {
        if (position < 0 || count > length - position) {
            throw failure(length, "truncated: the file ends in " + what + "; get or export it again");
        }
    }

    /** The byte at a position, 0 to 255. */
    public int at(long position) throws IOException {
        return Byte.toUnsignedInt(window[place(position, 1)]);
    }

    public short shortAt(long position, ByteOrder order) throws IOException {
        short value = (short) SHORTS.get(window, place(position, Short.BYTES));
        return order == ByteOrder.LITTLE_ENDIAN ? value : Short.reverseBytes(value);
    }

    public int intAt(long position, ByteOrder order) throws IOException {
        int value = (int) INTS.get(window, place(position, Integer.BYTES));
        return order == ByteOrder.LITTLE_ENDIAN ? value : Integer.reverseBytes(value);
    }

    public float floatAt(long position, ByteOrder order) throws IOException {
        return Float.intBitsToFloat(intAt(position, order));
    }

    public double doubleAt(long position, ByteOrder order) throws IOException {
        long value = (long) LONGS.get(window, place(position, Long.BYTES));
        return Double.longBitsToDouble(order == ByteOrder.LITTLE_ENDIAN ? value : Long.reverseBytes(value));
    }

    /** A copy of the bytes from a position on; the range must be within the length. */
    public byte[] copy(long position, int count) throws IOException {
        byte[] bytes = new byte[count];
        copy(position, bytes, count);
        return bytes;
    }

    /** Copies bytes from a position on to an array's start; the range must be within the length. */
    public void copy(long position, byte[] target, int count) throws IOException {
        for (int done = 0; done < count; ) {
            int from = place(position + done, 1);
            int step = Math.min(count - done, windowLength - from);
            System.arraycopy(window, from, target, done, step);
            done += step;
        }
    }

    /** Whether the bytes start with these characters, one byte each. */
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

    /** The index of a value in the window, which is loaded if necessary. */
    private int place(long position, int count) throws IOException {
        long place = position - windowStart;
        if (place >= 0 && place + count <= windowLength) {
            return (int) place;
        }
        load(position, count);
        return 0;
    }

    private void load(long position, int count) throws IOException {
        require(position, count, "the middle of a value");
        ByteBuffer target = ByteBuffer.wrap(window, 0, (int) Math.min(window.length, length - position));
        windowLength = 0;
        while (target.hasRemaining()) {
            if (source.read(target, position + target.position()) < 0) {
                throw failure(position, "the file became shorter while it was read");
            }
        }
        windowStart = position;
        windowLength = target.position();
    }
}
