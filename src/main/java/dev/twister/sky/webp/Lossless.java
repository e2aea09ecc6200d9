package dev.twister.sky.webp;

import dev.twister.sky.webp.LosslessTransform.ColorIndexing;
import dev.twister.sky.webp.LosslessTransform.CrossColor;
import dev.twister.sky.webp.LosslessTransform.LosslessPrediction;
import dev.twister.sky.webp.WebpContainer.WebpImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Decodes VP8L streams (RFC 9649, section 3). */
final class Lossless {
    static final int SIGNATURE = 0x2f;

    /** The signature, the size and the version. */
    static final int HEADER_BYTES = 5;

    private static final int PREDICTOR = 0;
    private static final int CROSS_COLOR = 1;
    private static final int SUBTRACT_GREEN = 2;
    private static final int LITERALS = 256;
    private static final int LENGTHS = 24;
    private static final int DISTANCES = 40;
    private static final int MOST_CACHE_BITS = 11;

    /** Section 3.6.2.2: by distance code, rows up in the upper four bits, 8 minus columns in the lower. */
    private static final int[] NEAR = Vp8Tables.numbers("""
            24 7 23 25 40 6 39 41 22 26 38 42 56 5 55 57 21 27 54 58 37 43 72 4 71 73 20 28 53 59 70 74 36 44 88
            69 75 52 60 3 87 89 19 29 86 90 35 45 68 76 85 91 51 61 104 2 103 105 18 30 102 106 34 46 84 92 67
            77 101 107 50 62 120 1 119 121 83 93 17 31 100 108 66 78 118 122 33 47 117 123 49 63 99 109 82 94 0
            116 124 65 79 16 32 98 110 48 115 125 81 95 64 114 126 97 111 80 113 127 96 112
            """);

    /** The five codes of a part of the picture: green and lengths, red, blue, alpha, distances. */
    private record Group(PrefixCode green, PrefixCode red, PrefixCode blue, PrefixCode alpha, PrefixCode distance) {
        static Group read(LosslessBits bits, int cacheBits) throws IOException {
            int cached = cacheBits > 0 ? 1 << cacheBits : 0;
            return new Group(
                    PrefixCode.read(bits, LITERALS + LENGTHS + cached),
                    PrefixCode.read(bits, LITERALS),
                    PrefixCode.read(bits, LITERALS),
                    PrefixCode.read(bits, LITERALS),
                    PrefixCode.read(bits, DISTANCES));
        }
    }

    private final LosslessBits bits;

    private Lossless(LosslessBits bits) {
        this.bits = bits;
    }

    /**
     * Decodes a picture.
     *
     * @param bits from the first transform on
     * @return its texels as {@link WebpImage} has them
     */
    static int[] decode(LosslessBits bits, int width, int height) throws IOException {
        return new Lossless(bits).picture(width, height);
    }

    private int[] picture(int width, int height) throws IOException {
        List<LosslessTransform> transforms = new ArrayList<>();
        int stored = width;
        int seen = 0;
        while (bits.flag()) {
            int type = bits.read(2);
            WebpDamage.check((seen & 1 << type) == 0, "one transform twice");
            seen |= 1 << type;
            LosslessTransform transform = switch (type) {
                case PREDICTOR -> {
                    int block = bits.read(3) + 2;
                    yield new LosslessPrediction(blocks(stored, height, block), stored, block);
                }
                case CROSS_COLOR -> {
                    int block = bits.read(3) + 2;
                    yield new CrossColor(blocks(stored, height, block), stored, block);
                }
                case SUBTRACT_GREEN -> LosslessTransform::addGreen;
                default -> new ColorIndexing(texels(bits.read(8) + 1, 1, false), stored, height);
            };
            if (transform instanceof ColorIndexing indexing) {
                stored = indexing.packedWidth();
            }
            transforms.add(transform);
        }
        int[] texels = texels(stored, height, true);
        for (LosslessTransform transform : transforms.reversed()) {
            texels = transform.inverse(texels);
        }
        return texels;
    }

    /** A picture with one texel per block of another. */
    private int[] blocks(int width, int height, int blockBits) throws IOException {
        return texels(LosslessTransform.blocks(width, blockBits), LosslessTransform.blocks(height, blockBits), false);
    }

    /**
     * Decodes texels before any transform.
     *
     * @param main whether parts of it may have codes of their own
     */
    private int[] texels(int width, int height, boolean main) throws IOException {
        boolean hasCache = bits.flag();
        int cacheBits = hasCache ? bits.read(4) : 0;
        WebpDamage.check(hasCache == cacheBits > 0 && cacheBits <= MOST_CACHE_BITS, "a color cache of no size");
        int blockBits = 0;
        int[] groupOf = {};
        int groupCount = 1;
        if (main && bits.flag()) {
            blockBits = bits.read(3) + 2;
            groupOf = blocks(width, height, blockBits);
            for (int i = 0; i < groupOf.length; i++) {
                groupOf[i] = groupOf[i] >> 8 & 0xffff;
                groupCount = Math.max(groupCount, groupOf[i] + 1);
            }
        }
        List<Group> groups = new ArrayList<>();
        for (int i = 0; i < groupCount; i++) {
            groups.add(Group.read(bits, cacheBits));
        }
        return texels(
                width,
                height,
                new Parts(groups, groupOf, blockBits, LosslessTransform.blocks(width, blockBits)),
                cacheBits);
    }

    /** Which codes a texel has. */
    @SuppressWarnings("ArrayRecordComponent") // read in place
    private record Parts(List<Group> groups, int[] groupOf, int blockBits, int blocksPerRow) {
        Group at(int column, int row) {
            return groupOf.length == 0
                    ? groups.getFirst()
                    : groups.get(groupOf[(row >> blockBits) * blocksPerRow + (column >> blockBits)]);
        }

        boolean startsAt(int column) {
            return groupOf.length > 0 && (column & (1 << blockBits) - 1) == 0;
        }
    }

    private int[] texels(int width, int height, Parts parts, int cacheBits) throws IOException {
        int[] argb = new int[width * height];
        int[] cache = new int[1 << cacheBits];
        int cached = 0;
        int column = 0;
        int row = 0;
        int at = 0;
        Group group = parts.at(0, 0);
        while (at < argb.length) {
            if (parts.startsAt(column)) {
                group = parts.at(column, row);
            }
            int symbol = group.green().next(bits);
            int count = 1;
            if (symbol < LITERALS) {
                int red = group.red().next(bits);
                int blue = group.blue().next(bits);
                argb[at] = group.alpha().next(bits) << 24 | red << 16 | symbol << 8 | blue;
            } else if (symbol < LITERALS + LENGTHS) {
                count = prefixed(symbol - LITERALS);
                int distance = distance(prefixed(group.distance().next(bits)), width);
                WebpDamage.check(distance <= at && count <= argb.length - at, "a copy of texels beyond the picture");
                copy(argb, at, distance, count);
            } else {
                cached = cache(argb, cached, at, cache, cacheBits);
                argb[at] = cache[symbol - LITERALS - LENGTHS];
            }
            at += count;
            column += count;
            if (column >= width) {
                row += column / width;
                column %= width;
                if (cacheBits > 0) {
                    cached = cache(argb, cached, at, cache, cacheBits);
                }
            }
            if (count > 1 && at < argb.length) {
                group = parts.at(column, row);
            }
        }
        return argb;
    }

    /** Puts texels into the color cache that are not yet there. */
    private static int cache(int[] argb, int from, int to, int[] cache, int cacheBits) {
        for (int i = from; i < to; i++) {
            cache[(0x1e35a7bd * argb[i]) >>> (Integer.SIZE - cacheBits)] = argb[i];
        }
        return to;
    }

    private static void copy(int[] argb, int at, int distance, int count) {
        if (distance >= count) {
            System.arraycopy(argb, at - distance, argb, at, count);
        } else {
            for (int i = at; i < at + count; i++) {
                argb[i] = argb[i - distance];
            }
        }
    }

    /** A length or a distance, from its prefix and what follows. */
    private int prefixed(int prefix) throws IOException {
        if (prefix < 4) {
            return prefix + 1;
        }
        int extra = (prefix - 2) >> 1;
        return ((2 + (prefix & 1)) << extra) + bits.read(extra) + 1;
    }

    private static int distance(int code, int width) {
        if (code > NEAR.length) {
            return code - NEAR.length;
        }
        int near = NEAR[code - 1];
        return Math.max(1, (near >> 4) * width + 8 - (near & 15));
    }
}
