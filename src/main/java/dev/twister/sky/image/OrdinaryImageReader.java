package dev.twister.sky.image;

import dev.twister.sky.SkyboxLimits;
import dev.twister.sky.image.FileBytes.FileChangedException;
import dev.twister.sky.radiance.RadianceHeader;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/** Reads PNG and JPEG images through ImageIO. */
public final class OrdinaryImageReader {
    /** What a decoder is asked for. */
    private interface Step<T> {
        T run() throws IOException;
    }

    /** What a decoded image becomes. */
    public interface Conversion<T> {
        T of(BufferedImage image, ImageMeaning meaning) throws IOException;
    }

    private OrdinaryImageReader() {}

    /**
     * Reads an image.
     *
     * @param warnings told of what the file says and is not used
     */
    public static <T> T read(
            FileBytes file, OrdinaryImageFormat format, Conversion<T> conversion, Consumer<String> warnings)
            throws IOException {
        EncodedImage encoded = format.open(file, warnings);
        Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName(format.name());
        if (!readers.hasNext()) {
            throw new IOException("this Java runtime cannot read " + format);
        }
        ImageReader reader = readers.next();
        ImageMeaning meaning = encoded.meaning();
        try (ImageInputStream stream = new MemoryCacheImageInputStream(encoded.decodable())) {
            reader.setInput(stream, true, true);
            return conversion.of(decode(reader, format, encoded, meaning), meaning);
        } finally {
            reader.dispose();
        }
    }

    /** Decodes what the reader has as its input. */
    public static BufferedImage decode(
            ImageReader reader, OrdinaryImageFormat format, EncodedImage encoded, ImageMeaning meaning)
            throws IOException {
        int width = attempt(format, () -> reader.getWidth(0));
        int height = attempt(format, () -> reader.getHeight(0));
        ScanOrder order = meaning.order(width, height);
        SkyboxLimits.checkSize(order.width(), order.height());
        encoded.checkTexels((long) width * height);
        List<String> complaints = new ArrayList<>();
        reader.addIIOReadWarningListener((source, complaint) -> complaints.add(complaint));
        Optional<CmykColors> cmyk = encoded.cmyk();
        BufferedImage image =
                attempt(format, () -> cmyk.isPresent() ? cmyk.get().rgb(reader.readRaster(0, null)) : reader.read(0));
        // libjpeg fills what is missing with gray and only warns.
        if (complaints.stream().anyMatch(OrdinaryImageReader::saysTruncated)) {
            throw new IOException("the " + format + " ends before its last texel");
        }
        return image;
    }

    private static <T> T attempt(OrdinaryImageFormat format, Step<T> step) throws IOException {
        try {
            return step.run();
        } catch (IllegalArgumentException
                | IllegalStateException
                | IndexOutOfBoundsException
                | NegativeArraySizeException
                | ClassCastException
                | ArithmeticException
                | NullPointerException damaged) {
            // ImageIO's decoders answer some damaged files so.
            throw new IOException("a damaged " + format + " (" + damaged + ")", damaged);
        } catch (IOException unreadable) {
            rethrowIfNotTheContent(unreadable);
            throw new IOException(
                    "cannot be decoded as " + format + " (" + RadianceHeader.quotable("" + unreadable.getMessage())
                            + ")",
                    unreadable);
        }
    }

    /** ImageIO takes these for the file's fault; but a larger heap helps, or another try. */
    private static void rethrowIfNotTheContent(IOException failure) throws IOException {
        for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
            if (cause instanceof OutOfMemoryError memory) {
                throw memory;
            }
            if (cause instanceof FileChangedException changed) {
                throw changed;
            }
        }
    }

    private static boolean saysTruncated(String complaint) {
        String words = complaint.toLowerCase(Locale.ROOT);
        return words.contains("premature end") || words.contains("truncated");
    }
}
