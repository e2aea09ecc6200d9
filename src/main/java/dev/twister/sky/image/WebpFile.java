package dev.twister.sky.image;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;
import java.util.function.Consumer;

/** A WebP file; of an animation the first picture. */
final class WebpFile implements EncodedImage {
    private static final String START = "RIFF";
    private static final String KIND = "WEBP";
    private static final int KIND_AT = 8;

    /** The chunk of pictures with more than their texels, and its flag of a color profile. */
    private static final String EXTENDED = "VP8X";

    private static final int EXTENDED_AT = 12;
    private static final int FLAGS_AT = 20;
    private static final int PROFILE = 0x20;

    private final FileBytes file;

    WebpFile(FileBytes file, Consumer<String> warnings) throws IOException {
        this.file = file;
        if (holds(file, EXTENDED_AT, EXTENDED) && file.length() > FLAGS_AT && (file.at(FLAGS_AT) & PROFILE) != 0) {
            warnings.accept("the color profile of WebP is not read; read as sRGB");
        }
    }

    static boolean startsIn(FileBytes file) throws IOException {
        return file.startsWith(START) && holds(file, KIND_AT, KIND);
    }

    private static boolean holds(FileBytes file, int position, String characters) throws IOException {
        boolean holds = file.length() >= position + characters.length();
        for (int i = 0; holds && i < characters.length(); i++) {
            holds = file.at(position + i) == characters.charAt(i);
        }
        return holds;
    }

    @Override
    public InputStream decodable() {
        return new FileRange(file, 0, file.length());
    }

    @Override
    public Optional<CmykColors> cmyk() {
        return Optional.empty();
    }

    @Override
    public ImageMeaning meaning() {
        return ImageMeaning.opaque(CurveEncoding.SRGB, ExifOrientation.UPRIGHT);
    }

    /** A few bytes may hold a large picture of one color. */
    @Override
    public void checkTexels(long texels) {}
}
