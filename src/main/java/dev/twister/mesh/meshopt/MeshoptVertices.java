package dev.twister.mesh.meshopt;

import java.util.Arrays;

/**
 * Decodes elements of equal length (mode ATTRIBUTES of {@code EXT_meshopt_compression}, versions 0 and 1). Each byte of
 * an element is a column; columns come in groups of 16 differences.
 */
public final class MeshoptVertices {
    private static final int BLOCK_BYTES = 0x2000;
    private static final int MOST_IN_BLOCK = 256;
    private static final int GROUP = 16;

    /** Numbers of bits per difference, by the two bits of a group's header. */
    private static final int[] BITS_OF_VERSION_0 = {0, 2, 4, 8};

    private static final int[] SMALL_BITS = {0, 1, 2, 4};
    private static final int[] LARGE_BITS = {1, 2, 4, 8};

    /** Kinds of a column in version 1, besides small and large bits. */
    private static final int LARGE = 1;

    private static final int ZEROS = 2;
    private static final int VERBATIM = 3;

    private final byte[] source;
    private final byte[] target;
    private final int stride;
    private final int version;
    private final int tail;
    private final byte[] last;
    private final byte[] columns;
    private int at = 1;

    private MeshoptVertices(byte[] source, int count, int stride) {
        this.source = source;
        this.stride = stride;
        this.target = new byte[count * stride];
        this.version = source[0] & 0xf;
        this.tail = source.length - stride - (version == 0 ? 0 : stride / 4);
        this.last = Arrays.copyOfRange(source, tail, tail + stride);
        this.columns = new byte[stride * MOST_IN_BLOCK];
    }

    /**
     * The elements.
     *
     * @param stride bytes per element, a multiple of 4 up to 256
     * @throws IndexOutOfBoundsException if the bytes are damaged
     */
    public static byte[] decode(byte[] source, int count, int stride) {
        if ((source[0] & 0xf0) != 0xa0 || (source[0] & 0xf) > 1) {
            throw new IndexOutOfBoundsException("unknown header");
        }
        MeshoptVertices vertices = new MeshoptVertices(source, count, stride);
        int inBlock = Math.min((BLOCK_BYTES / stride) & -GROUP, MOST_IN_BLOCK);
        for (int first = 0; first < count; first += inBlock) {
            vertices.readBlock(first, Math.min(count - first, inBlock));
        }
        return vertices.target;
    }

    private void readBlock(int first, int elements) {
        int kinds = at;
        at += version == 0 ? 0 : stride / 4;
        Arrays.fill(columns, (byte) 0);
        for (int column = 0; column < stride; column++) {
            int kind = version == 0 ? 0 : (source[kinds + column / 4] >> (2 * (column % 4))) & 3;
            if (kind == VERBATIM) {
                System.arraycopy(source, at, columns, MOST_IN_BLOCK * column, elements);
                at += elements;
            } else if (kind != ZEROS) {
                int[] bits = kind == LARGE ? LARGE_BITS : SMALL_BITS;
                readColumn(MOST_IN_BLOCK * column, elements, version == 0 ? BITS_OF_VERSION_0 : bits);
            }
        }
        for (int element = 0; element < elements; element++) {
            for (int column = 0; column < stride; column += 4) {
                add(element, column);
            }
            System.arraycopy(last, 0, target, (first + element) * stride, stride);
        }
    }

    private void readColumn(int column, int elements, int[] bits) {
        int groups = Math.ceilDiv(elements, GROUP);
        int headers = at;
        at += Math.ceilDiv(groups, 4);
        for (int group = 0; group < groups; group++) {
            int header = (source[headers + group / 4] >> (2 * (group % 4))) & 3;
            readGroup(column + GROUP * group, bits[header]);
        }
    }

    private void readGroup(int to, int bits) {
        if (bits == 8) {
            System.arraycopy(source, at, columns, to, GROUP);
            at += GROUP;
        } else if (bits > 0) {
            int packed = at;
            at += 2 * bits;
            int largest = (1 << bits) - 1;
            int inByte = 8 / bits;
            for (int i = 0; i < GROUP; i++) {
                // Single bits begin at the lowest, others at the highest ones.
                int place = bits == 1 ? i % inByte : inByte - 1 - i % inByte;
                int value = (source[packed + i / inByte] >> (bits * place)) & largest;
                columns[to + i] = value == largest ? source[at++] : (byte) value;
            }
        }
    }

    /** Adds the differences of four columns to the last element. */
    private void add(int element, int column) {
        int mode = version == 0 ? 0 : source[tail + stride + column / 4];
        switch (mode & 3) {
            case 0 -> {
                for (int i = column; i < column + 4; i++) {
                    last[i] += (byte) signed(difference(element, i, 1));
                }
            }
            case 1 -> {
                put(column, 2, number(column, 2) + signed(difference(element, column, 2)));
                put(column + 2, 2, number(column + 2, 2) + signed(difference(element, column + 2, 2)));
            }
            case 2 ->
                put(
                        column,
                        4,
                        number(column, 4) ^ Integer.rotateRight(difference(element, column, 4), (mode >> 4) & 0xf));
            default -> throw new IndexOutOfBoundsException("unknown mode of a channel");
        }
    }

    private int difference(int element, int column, int bytes) {
        int value = 0;
        for (int i = 0; i < bytes; i++) {
            value |= (columns[MOST_IN_BLOCK * (column + i) + element] & 0xff) << (8 * i);
        }
        return value;
    }

    private int number(int column, int bytes) {
        int value = 0;
        for (int i = 0; i < bytes; i++) {
            value |= (last[column + i] & 0xff) << (8 * i);
        }
        return value;
    }

    private void put(int column, int bytes, int value) {
        for (int i = 0; i < bytes; i++) {
            last[column + i] = (byte) (value >> (8 * i));
        }
    }

    /** A signed number from one with the sign in its lowest bit. */
    static int signed(int value) {
        return (value >>> 1) ^ -(value & 1);
    }
}
