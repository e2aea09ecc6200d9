package dev.twister.sky;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/** Reads PNG and JPEG panoramas through ImageIO. */
final class OrdinaryImageReader {
    private OrdinaryImageReader() {}

    static Skybox read(ByteBuffer content, OrdinaryImageFormat format) throws IOException {
        format.check(content);
        Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName(format.name());
        if (!readers.hasNext()) {
            throw new IOException("this Java runtime cannot read " + format);
        }
        ImageReader reader = readers.next();
        int fileBytes = content.remaining();
        try (ImageInputStream stream = new MemoryCacheImageInputStream(new ByteBufferInput(content))) {
            return LinearImage.skybox(decode(reader, stream, format, fileBytes));
        } finally {
            reader.dispose();
        }
    }

    static BufferedImage decode(ImageReader reader, ImageInputStream stream, OrdinaryImageFormat format, int fileBytes)
            throws IOException {
        List<String> warnings = new ArrayList<>();
        BufferedImage image;
        try {
            reader.setInput(stream, true, true);
            long width = reader.getWidth(0);
            long height = reader.getHeight(0);
            SkyboxLimits.checkSize(width, height);
            format.checkSize(width * height, fileBytes);
            reader.addIIOReadWarningListener((source, warning) -> warnings.add(warning));
            image = reader.read(0);
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
            rethrowOutOfMemory(unreadable);
            throw new IOException(
                    "cannot be decoded as " + format + " (" + RadianceHeader.quotable("" + unreadable.getMessage())
                            + "); RGB and greyscale are read, CMYK is not",
                    unreadable);
        }
        // libjpeg fills what is missing with grey and only warns.
        if (warnings.stream().anyMatch(OrdinaryImageReader::saysTruncated)) {
            throw new IOException("the " + format + " ends before its last texel");
        }
        return image;
    }

    /** ImageIO takes that for the file's fault; but a larger heap helps. */
    private static void rethrowOutOfMemory(IOException failure) {
        for (Throwable cause = failure.getCause(); cause != null; cause = cause.getCause()) {
            if (cause instanceof OutOfMemoryError memory) {
                throw memory;
            }
        }
    }

    private static boolean saysTruncated(String warning) {
        String words = warning.toLowerCase(Locale.ROOT);
        return words.contains("premature end") || words.contains("truncated");
    }
}
