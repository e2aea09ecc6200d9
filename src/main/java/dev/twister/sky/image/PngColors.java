package dev.twister.sky.image;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleUnaryOperator;
import java.util.zip.InflaterInputStream;
import java.util.zip.ZipException;

/**
 * What the chunks of a PNG file say of its colors: cICP before iCCP before sRGB before gAMA and cHRM, and sRGB where
 * none of them says anything that can be used.
 */
final class PngColors {
    /** What gAMA and cHRM give their numbers in. */
    private static final double UNIT = 100_000;

    /** The gAMA value that is written beside an sRGB curve. */
    private static final double SRGB_GAMMA = 1 / 2.2;

    private static final double LARGEST_GAMMA = 10;
    private static final int MOST_PROFILE_BYTES = 1 << 25;

    private static final Primaries BT_2020 = Primaries.of(0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290);
    private static final Primaries DISPLAY_P3 = Primaries.of(0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290);

    private final PngFile file;
    private final Consumer<String> warnings;

    private PngColors(PngFile file, Consumer<String> warnings) {
        this.file = file;
        this.warnings = warnings;
    }

    /**
     * The encoding of a file's samples.
     *
     * @param warnings told of what the file says and is not used
     */
    static ColorEncoding of(PngFile file, Consumer<String> warnings) {
        PngColors colors = new PngColors(file, warnings);
        return colors.codePoints().or(colors::profile).or(colors::srgb).orElseGet(colors::gammaAndPrimaries);
    }

    private Optional<ColorEncoding> codePoints() {
        Optional<byte[]> chunk = file.ancillary("cICP");
        if (chunk.isEmpty()) {
            return Optional.empty();
        }
        byte[] codes = chunk.get();
        Optional<ColorEncoding> encoding = Optional.empty();
        if (codes.length == 4 && codes[2] == 0 && codes[3] == 1) {
            encoding = primaries(codes[0])
                    .flatMap(primaries -> curve(codes[1]).map(curve -> new CurveEncoding(curve, primaries)));
        }
        if (encoding.isEmpty()) {
            warnings.accept("its cICP chunk names colors that are not supported and is ignored");
        }
        return encoding;
    }

    /** By its number in ITU-T H.273. */
    private static Optional<Primaries> primaries(int code) {
        return switch (code) {
            case 1 -> Optional.of(Primaries.SRGB);
            case 9 -> Optional.of(BT_2020);
            case 12 -> Optional.of(DISPLAY_P3);
            default -> Optional.empty();
        };
    }

    /** By its number in ITU-T H.273. */
    private static Optional<DoubleUnaryOperator> curve(int code) {
        return switch (code) {
            case 1, 6, 14, 15 -> Optional.of(PngColors::linearOfVideo);
            case 8 -> Optional.of(DoubleUnaryOperator.identity());
            case 13 -> Optional.of(CurveEncoding::linear);
            default -> Optional.empty();
        };
    }

    private static double linearOfVideo(double encoded) {
        return encoded < 0.081 ? encoded / 4.5 : Math.pow((encoded + 0.099) / 1.099, 1 / 0.45);
    }

    private Optional<ColorEncoding> profile() {
        Optional<byte[]> chunk = file.ancillary("iCCP");
        if (chunk.isEmpty()) {
            return Optional.empty();
        }
        try {
            return Optional.of(ProfileEncoding.of(inflated(chunk.get()), file.isGray() ? 1 : 3));
        } catch (IOException unusable) {
            warnings.accept(ProfileEncoding.ignored(unusable));
            return Optional.empty();
        }
    }

    /** A name, a zero, the method of compression, which is zero too, and the compressed profile. */
    private static byte[] inflated(byte[] chunk) throws IOException {
        int name = 0;
        while (name < chunk.length && chunk[name] != 0) {
            name++;
        }
        int start = name + 2;
        if (start >= chunk.length || chunk[start - 1] != 0) {
            throw new IOException("is damaged");
        }
        try (InflaterInputStream profile =
                new InflaterInputStream(new ByteArrayInputStream(chunk, start, chunk.length - start))) {
            byte[] data = profile.readNBytes(MOST_PROFILE_BYTES + 1);
            if (data.length > MOST_PROFILE_BYTES) {
                throw new IOException("is too large");
            }
            return data;
        } catch (ZipException | EOFException damaged) {
            throw new IOException("is damaged", damaged);
        }
    }

    private Optional<ColorEncoding> srgb() {
        return file.ancillary("sRGB").map(intent -> CurveEncoding.SRGB);
    }

    private ColorEncoding gammaAndPrimaries() {
        return new CurveEncoding(
                file.ancillary("gAMA").map(this::power).orElse(CurveEncoding.SRGB.curve()),
                file.ancillary("cHRM").map(this::chromaticities).orElse(Primaries.SRGB));
    }

    private DoubleUnaryOperator power(byte[] chunk) {
        double gamma = chunk.length == Integer.BYTES
                ? Integer.toUnsignedLong(ByteBuffer.wrap(chunk).getInt()) / UNIT
                : 0;
        if (!(gamma >= 1 / LARGEST_GAMMA && gamma <= LARGEST_GAMMA)) {
            warnings.accept("its gAMA chunk makes no sense and is ignored");
            return CurveEncoding.SRGB.curve();
        }
        // So close to 1 / 2.2, the sRGB curve is meant, which no power is.
        boolean srgb = Math.abs(gamma / SRGB_GAMMA - 1) <= 0.0101;
        return srgb ? CurveEncoding.SRGB.curve() : encoded -> Math.pow(encoded, 1 / gamma);
    }

    /** In the chunk the white comes first. */
    private Primaries chromaticities(byte[] chunk) {
        if (chunk.length == 8 * Integer.BYTES) {
            double[] xy = new double[8];
            for (int i = 0; i < 8; i++) {
                int value = ByteBuffer.wrap(chunk).getInt(Integer.BYTES * i);
                xy[(i + 6) % 8] = Integer.toUnsignedLong(value) / UNIT;
            }
            Primaries primaries = Primaries.of(xy);
            if (primaries.makeSense()) {
                return primaries;
            }
        }
        warnings.accept("its cHRM chunk makes no sense and is ignored");
        return Primaries.SRGB;
    }
}
