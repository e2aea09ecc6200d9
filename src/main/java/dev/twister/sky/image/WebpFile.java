package dev.twister.sky.image;

import dev.twister.sky.SkyboxLimits;
import dev.twister.sky.webp.WebpContainer;
import dev.twister.sky.webp.WebpContainer.WebpImage;
import java.awt.Point;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.DataBufferInt;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;

/** Reads WebP files; of an animation the first picture. */
public final class WebpFile {
    private static final String START = "RIFF";
    private static final String KIND = "WEBP";
    private static final int KIND_AT = 8;

    /**
     * Texels that any file may have, and how many more for each of its bytes: a few bytes may hold a large picture of
     * one color, and no memory is taken for what a file cannot mean.
     */
    private static final long FREE_TEXELS = 1 << 24;

    private static final long TEXELS_PER_BYTE = 1 << 13;

    private WebpFile() {}

    public static boolean startsIn(FileBytes file) throws IOException {
        return file.startsWith(START)
                && file.length() >= KIND_AT + KIND.length()
                && new String(file.copy(KIND_AT, KIND.length()), StandardCharsets.ISO_8859_1).equals(KIND);
    }

    /**
     * Reads a picture.
     *
     * @param warnings told of what the file says and is not used
     */
    public static <T> T read(FileBytes file, OrdinaryImageReader.Conversion<T> conversion, Consumer<String> warnings)
            throws IOException {
        WebpContainer webp = new WebpContainer(file.copy(0, Math.toIntExact(file.length())));
        SkyboxLimits.checkEitherWay(webp.width(), webp.height());
        long most = FREE_TEXELS + TEXELS_PER_BYTE * file.length();
        if ((long) webp.width() * webp.height() > most) {
            throw new IOException("a WebP of " + webp.width() + " x " + webp.height() + " texels in " + file.length()
                    + " bytes; at most " + most + " texels are read from so few");
        }
        int orientation = webp.exif().map(ExifOrientation::of).orElse(ExifOrientation.UPRIGHT);
        return conversion.of(image(webp.decode()), ImageMeaning.opaque(colors(webp.profile(), warnings), orientation));
    }

    private static ColorEncoding colors(Optional<byte[]> profile, Consumer<String> warnings) {
        if (profile.isEmpty()) {
            return CurveEncoding.SRGB;
        }
        try {
            return ProfileEncoding.of(profile.get(), 3);
        } catch (IOException unusable) {
            warnings.accept(ProfileEncoding.ignored(unusable));
            return CurveEncoding.SRGB;
        }
    }

    private static BufferedImage image(WebpImage webp) {
        ColorModel colors =
                webp.hasAlpha() ? ColorModel.getRGBdefault() : new DirectColorModel(24, 0xff0000, 0xff00, 0xff);
        int[] masks = ((DirectColorModel) colors).getMasks();
        DataBufferInt texels = new DataBufferInt(webp.argb(), webp.argb().length);
        return new BufferedImage(
                colors,
                Raster.createPackedRaster(
                        texels,
                        webp.width(),
                        webp.height(),
                        webp.width(),
                        webp.hasAlpha() ? masks : Arrays.copyOf(masks, 3),
                        new Point()),
                false,
                null);
    }
}
