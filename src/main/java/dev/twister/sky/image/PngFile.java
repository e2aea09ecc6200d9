package dev.twister.sky.image;

import dev.twister.files.Deflate;
import dev.twister.sky.SkyboxLimits;
import dev.twister.sky.image.FileBytes.FileRange;
import dev.twister.sky.radiance.RadianceHeader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.zip.CRC32;

/**
 * What is in a PNG file (W3C Portable Network Graphics, third edition), checked before it is decoded. Java's own
 * decoder skips the checksums, believes in any length a chunk claims, makes room for any size the header claims, and
 * fails on ancillary chunks that it does not use; it is given no more than it needs.
 */
final class PngFile implements EncodedImage {
    private static final int SIGNATURE_BYTES = 8;
    private static final int FRAME_BYTES = 12;
    private static final int HEADER_BYTES = 13;
    private static final int PALETTE = 3;
    private static final List<String> KEPT = List.of("cICP", "iCCP", "sRGB", "gAMA", "cHRM", "tRNS", "eXIf");

    /** So much of a chunk is kept at most; the largest color profiles have a few million bytes. */
    private static final int MOST_KEPT_BYTES = 1 << 24;

    private static final int CHECKED_BYTES = 1 << 13;

    private final FileBytes file;
    private final Consumer<String> warnings;
    private final Map<String, byte[]> kept = new HashMap<>();
    private final List<InputStream> beforeData = new ArrayList<>();
    private final List<InputStream> data = new ArrayList<>();
    private final byte[] checked = new byte[CHECKED_BYTES];
    private long dataBytes;
    private int bits;
    private int colorType;

    /**
     * Checks lengths and checksums, the size, and that there is enough data for the size.
     *
     * @param warnings told of what the file says and is not used
     */
    PngFile(FileBytes file, Consumer<String> warnings) throws IOException {
        this.file = file;
        this.warnings = warnings;
        readChunks();
    }

    /** Header, palette and its opacities, and all data in one chunk. */
    @Override
    public InputStream decodable() {
        List<InputStream> parts = new ArrayList<>(beforeData);
        parts.add(chunkStart((int) dataBytes, "IDAT"));
        parts.addAll(data);
        // The decoder does not look at checksums.
        parts.add(new ByteArrayInputStream(new byte[4]));
        parts.add(chunkStart(0, "IEND"));
        parts.add(new ByteArrayInputStream(new byte[4]));
        return new SequenceInputStream(Collections.enumeration(parts));
    }

    /** What the data of an ancillary chunk say, where the file has it, undamaged. */
    Optional<byte[]> ancillary(String type) {
        return Optional.ofNullable(kept.get(type));
    }

    /** Whether texels have no color. */
    boolean isGray() {
        return (colorType & 2) == 0;
    }

    @Override
    public Optional<CmykColors> cmyk() {
        return Optional.empty();
    }

    @Override
    public ImageMeaning meaning() {
        int orientation = ancillary("eXIf").map(ExifOrientation::of).orElse(ExifOrientation.UPRIGHT);
        return new ImageMeaning(PngColors.of(this, warnings), orientation, isPalette(), transparentColor());
    }

    /** The file's own header and length were enough. */
    @Override
    public void checkTexels(long texels) {}

    private boolean isPalette() {
        return colorType == PALETTE;
    }

    /** The samples of the one color that is transparent; empty where there is none, or the palette says it. */
    private int[] transparentColor() {
        byte[] samples = isPalette() || (colorType & 4) != 0 ? new byte[0] : kept.getOrDefault("tRNS", new byte[0]);
        int channels = isGray() ? 1 : 3;
        if (samples.length != 2 * channels) {
            return new int[0];
        }
        int[] color = new int[channels];
        for (int channel = 0; channel < channels; channel++) {
            color[channel] = ByteBuffer.wrap(samples).getShort(2 * channel) & (1 << bits) - 1;
        }
        return color;
    }

    private void readChunks() throws IOException {
        long position = SIGNATURE_BYTES;
        long uncompressed = -1;
        String type = "";
        while (!type.equals("IEND")) {
            long left = file.length() - position - FRAME_BYTES;
            if (left < 0) {
                throw new IOException("the PNG ends before its IEND chunk");
            }
            int length = file.intAt(position);
            if (length < 0 || length > left) {
                throw new IOException("a PNG chunk of " + Integer.toUnsignedLong(length) + " bytes where only " + left
                        + " are left in the file");
            }
            type = new String(file.copy(position + 4, 4), StandardCharsets.ISO_8859_1);
            if (uncompressed < 0) {
                uncompressed = readHeader(position, type, length);
            }
            readChunk(position, type, length);
            position += FRAME_BYTES + length;
        }
        if (!Deflate.canHold(/* compressed= */ dataBytes, /* bytes= */ uncompressed)) {
            throw new IOException(
                    "a PNG of " + uncompressed + " bytes cannot come from " + dataBytes + " compressed ones");
        }
    }

    private void readChunk(long position, String type, int length) throws IOException {
        long start = position + 8;
        long end = start + length;
        boolean intact = checksum(position + 4, end) == file.intAt(end);
        boolean critical = Character.isUpperCase(type.charAt(0));
        if (critical && !intact) {
            throw new IOException(
                    "a damaged PNG: the checksum of its " + RadianceHeader.quotable(type) + " chunk does not match");
        }
        switch (type) {
            case "IHDR" -> {
                if (beforeData.isEmpty()) {
                    beforeData.add(new FileRange(file, 0, end + 4));
                }
            }
            case "PLTE" -> {
                if (isPalette()) {
                    beforeData.add(new FileRange(file, position, end + 4));
                }
            }
            case "IDAT" -> {
                if (length > 0) {
                    data.add(new FileRange(file, start, end));
                    dataBytes += length;
                }
            }
            default -> {
                boolean inPlace = data.isEmpty() || type.equals("eXIf");
                if (KEPT.contains(type) && inPlace && !kept.containsKey(type)) {
                    keep(position, type, length, intact);
                }
            }
        }
    }

    private void keep(long position, String type, int length, boolean intact) throws IOException {
        if (!intact || length > MOST_KEPT_BYTES) {
            warnings.accept("the " + type + " chunk is " + (intact ? "too large" : "damaged") + " and is ignored");
            return;
        }
        kept.put(type, file.copy(position + 8, length));
        if (type.equals("tRNS") && isPalette()) {
            beforeData.add(new FileRange(file, position, position + FRAME_BYTES + length));
        }
    }

    private long readHeader(long position, String type, int length) throws IOException {
        if (!type.equals("IHDR") || length != HEADER_BYTES) {
            throw new IOException("a PNG that does not start with its IHDR chunk");
        }
        long header = position + 8;
        long width = Integer.toUnsignedLong(file.intAt(header));
        long height = Integer.toUnsignedLong(file.intAt(header + 4));
        SkyboxLimits.checkEitherWay(width, height);
        bits = file.at(header + 8);
        colorType = file.at(header + 9);
        int channels = switch (colorType) {
            case 2 -> 3;
            case 4 -> 2;
            case 6 -> 4;
            default -> 1;
        };
        return width * height * channels * bits / 8;
    }

    private int checksum(long start, long end) throws IOException {
        CRC32 sum = new CRC32();
        for (long at = start; at < end; at += CHECKED_BYTES) {
            int count = (int) Math.min(CHECKED_BYTES, end - at);
            file.copy(at, checked, 0, count);
            sum.update(checked, 0, count);
        }
        return (int) sum.getValue();
    }

    private static InputStream chunkStart(int length, String type) {
        byte[] start = ByteBuffer.allocate(8)
                .putInt(length)
                .put(type.getBytes(StandardCharsets.ISO_8859_1))
                .array();
        return new ByteArrayInputStream(start);
    }
}
