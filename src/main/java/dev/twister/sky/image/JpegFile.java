package dev.twister.sky.image;

import dev.twister.sky.image.FileBytes.FileRange;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;

/**
 * What is in a JPEG file (ITU-T T.81): how many scans, what it says of its colors and orientation. Java's own decoder
 * is not shown what makes it fail: color profiles that it cannot use, and contradictions about the coding of colors.
 */
final class JpegFile implements EncodedImage {
    private static final int MARKER_BYTES = 2;
    private static final int LENGTH_BYTES = 2;
    private static final int BASELINE = 0xc0;
    private static final int PROGRESSIVE = 0xc2;
    private static final int FIRST_RESTART = 0xd0;
    private static final int END_OF_IMAGE = 0xd9;
    private static final int START_OF_SCAN = 0xda;
    private static final int APP0 = 0xe0;
    private static final int APP1 = 0xe1;
    private static final int APP2 = 0xe2;
    private static final int APP14 = 0xee;
    private static final String JFIF = "JFIF\0";
    private static final String EXIF = "Exif\0";
    private static final String PROFILE = "ICC_PROFILE\0";
    private static final String ADOBE = "Adobe";
    private static final int ADOBE_YCBCR = 1;
    private static final int ADOBE_YCCK = 2;

    /**
     * A block of 8 x 8 texels takes a bit at the very least, in progressive files; that is 512 texels a byte. Twice
     * that is allowed as a margin.
     */
    private static final long MOST_TEXELS_PER_BYTE = 1024;

    /** Every scan goes over the whole picture: 32 for the largest one, where programs write about 10. */
    private static final long MOST_SCANNED_TEXELS = 1L << 32;

    /** A piece of the file, from a marker to what comes after it. */
    private record Segment(long start, long end) {}

    private final FileBytes file;
    private final JpegScans scans = new JpegScans();
    private final JpegProfile profile = new JpegProfile();
    private final List<Segment> profileSegments = new ArrayList<>();
    private final ImageMeaning meaning;
    private final Optional<CmykColors> cmyk;
    private final List<Segment> hidden = new ArrayList<>();
    private Optional<byte[]> exif = Optional.empty();
    private Optional<Segment> adobe = Optional.empty();
    private int adobeTransform;
    private boolean jfif;
    private boolean ended;
    private long end;

    /**
     * Looks through a file.
     *
     * @param warnings told of what the file says and is not used
     * @throws IOException where its colors are none that are read
     */
    JpegFile(FileBytes file, Consumer<String> warnings) throws IOException {
        this.file = file;
        readSegments();
        int channels = scans.channels();
        cmyk = channels == 4
                ? Optional.of(new CmykColors(adobe.isPresent(), adobeTransform == ADOBE_YCCK))
                : Optional.empty();
        if (cmyk.isPresent()) {
            warnings.accept("a CMYK image; converted to RGB without a color profile");
            hidden.addAll(profileSegments);
        }
        ColorEncoding colors =
                profile.isPresent() && cmyk.isEmpty() ? profiled(channels, warnings) : CurveEncoding.SRGB;
        boolean contradiction = jfif ? adobeTransform != ADOBE_YCBCR : adobeTransform > ADOBE_YCBCR;
        if (channels == 3 && contradiction) {
            adobe.ifPresent(hidden::add);
        }
        int orientation = exif.map(ExifOrientation::of).orElse(ExifOrientation.UPRIGHT);
        meaning = ImageMeaning.opaque(colors, orientation);
    }

    @Override
    public InputStream decodable() {
        List<InputStream> parts = new ArrayList<>();
        long from = 0;
        hidden.sort(Comparator.comparingLong(Segment::start));
        for (Segment segment : hidden) {
            parts.add(new FileRange(file, from, segment.start()));
            from = segment.end();
        }
        parts.add(new FileRange(file, from, end));
        if (!ended && scans.areComplete()) {
            parts.add(new ByteArrayInputStream(new byte[] {(byte) 0xff, (byte) END_OF_IMAGE}));
        }
        return new SequenceInputStream(Collections.enumeration(parts));
    }

    @Override
    public Optional<CmykColors> cmyk() {
        return cmyk;
    }

    @Override
    public ImageMeaning meaning() {
        return meaning;
    }

    @Override
    public void checkTexels(long texels) throws IOException {
        if (texels > MOST_TEXELS_PER_BYTE * file.length()) {
            throw new IOException(texels + " texels cannot come from a JPEG of " + file.length() + " bytes");
        }
        if (texels * scans.count() > MOST_SCANNED_TEXELS) {
            throw new IOException("a JPEG of " + texels + " texels in " + scans.count() + " scans; at most "
                    + Math.max(1, MOST_SCANNED_TEXELS / texels) + " scans of such a size are read");
        }
    }

    /** Leaves a profile of three channels to the decoder, which does not use one of a single channel. */
    private ColorEncoding profiled(int channels, Consumer<String> warnings) {
        try {
            ColorEncoding encoding = ProfileEncoding.of(profile.data(), channels);
            if (channels == 3) {
                return CurveEncoding.SRGB;
            }
            hidden.addAll(profileSegments);
            return encoding;
        } catch (IOException unusable) {
            warnings.accept(ProfileEncoding.ignored(unusable));
            hidden.addAll(profileSegments);
            return CurveEncoding.SRGB;
        }
    }

    private void readSegments() throws IOException {
        long position = nextMarker(0);
        while (position < file.length() && !ended) {
            int marker = file.at(position + 1);
            long next = position + MARKER_BYTES;
            // The end of an image without scans is that of tables for the image after it.
            if (marker == END_OF_IMAGE && scans.count() > 0) {
                ended = true;
            } else if (hasLength(marker) && next + LENGTH_BYTES <= file.length()) {
                long start = next + LENGTH_BYTES;
                next = Math.min(file.length(), next + (file.at(next) << 8 | file.at(next + 1)));
                readSegment(marker, new Segment(position, next), payload(start, next));
            }
            end = next;
            position = nextMarker(next);
        }
        if (!ended) {
            end = file.length();
        }
    }

    private byte[] payload(long start, long next) throws IOException {
        return file.copy(start, (int) Math.max(0, next - start));
    }

    private void readSegment(int marker, Segment segment, byte[] payload) {
        switch (marker) {
            case BASELINE, BASELINE + 1, PROGRESSIVE -> scans.startFrame(marker == PROGRESSIVE, payload);
            case START_OF_SCAN -> scans.add(payload);
            case APP0 -> jfif |= startsWith(payload, JFIF);
            case APP1 -> {
                if (exif.isEmpty() && startsWith(payload, EXIF)) {
                    exif = Optional.of(Arrays.copyOfRange(payload, EXIF.length() + 1, payload.length));
                }
            }
            case APP2 -> {
                if (startsWith(payload, PROFILE) && payload.length >= PROFILE.length() + 2) {
                    profile.add(Arrays.copyOfRange(payload, PROFILE.length(), payload.length));
                    profileSegments.add(segment);
                }
            }
            case APP14 -> {
                if (startsWith(payload, ADOBE) && payload.length >= 12) {
                    adobe = Optional.of(segment);
                    adobeTransform = Byte.toUnsignedInt(payload[11]);
                }
            }
            default -> {
                // Nothing that matters before decoding.
            }
        }
    }

    /** The next marker from a position on, stuffed and filling bytes aside; the file's length where there is none. */
    private long nextMarker(long from) throws IOException {
        long position = from;
        while (position + 1 < file.length()) {
            if (file.at(position) != 0xff) {
                position++;
            } else {
                int marker = file.at(position + 1);
                if (marker != 0 && marker != 0xff) {
                    return position;
                }
                position += marker == 0 ? 2 : 1;
            }
        }
        return file.length();
    }

    private static boolean hasLength(int marker) {
        return marker >= BASELINE && (marker < FIRST_RESTART || marker > END_OF_IMAGE);
    }

    private static boolean startsWith(byte[] payload, String characters) {
        byte[] expected = characters.getBytes(StandardCharsets.ISO_8859_1);
        return payload.length > expected.length
                && Arrays.equals(payload, 0, expected.length, expected, 0, expected.length);
    }

    /** The color profile of a JPEG file, which comes in numbered pieces (ICC.1:2022, B.4). */
    private static final class JpegProfile {
        private static final int HEAD_BYTES = 2;

        private final SortedMap<Integer, byte[]> pieces = new TreeMap<>();
        private int expected;
        private boolean damaged;

        /**
         * Takes a piece.
         *
         * @param payload its number, the number of pieces, and its part of the profile
         */
        void add(byte[] payload) {
            int number = Byte.toUnsignedInt(payload[0]);
            int count = Byte.toUnsignedInt(payload[1]);
            damaged |= number > count || (!pieces.isEmpty() && count != expected);
            expected = count;
            damaged |= pieces.put(number, payload) != null;
        }

        boolean isPresent() {
            return !pieces.isEmpty();
        }

        /**
         * The pieces put together, which some programs number from 0.
         *
         * @throws IOException where they do not fit together, as {@link ProfileEncoding#ignored} tells
         */
        byte[] data() throws IOException {
            int first = pieces.firstKey();
            if (damaged || pieces.size() != expected || first > 1 || pieces.lastKey() - first != expected - 1) {
                throw new IOException("is damaged");
            }
            ByteArrayOutputStream data = new ByteArrayOutputStream();
            for (byte[] piece : pieces.values()) {
                data.write(piece, HEAD_BYTES, piece.length - HEAD_BYTES);
            }
            if (data.size() == 0) {
                throw new IOException("is empty");
            }
            return data.toByteArray();
        }
    }
}
