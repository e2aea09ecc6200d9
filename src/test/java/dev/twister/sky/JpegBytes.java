package dev.twister.sky;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Creates JPEG files and inserts segments. */
public final class JpegBytes {
    private static final int SOI_BYTES = 2;

    private JpegBytes() {}

    public static byte[] of(BufferedImage image, boolean progressive) {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
            ImageWriteParam how = writer.getDefaultWriteParam();
            if (progressive) {
                how.setProgressiveMode(ImageWriteParam.MODE_DEFAULT);
            }
            writer.setOutput(stream);
            writer.write(null, new IIOImage(image, null, null), how);
        } catch (IOException impossible) {
            throw new AssertionError(impossible);
        } finally {
            writer.dispose();
        }
        return out.toByteArray();
    }

    /** An image of one color. */
    public static BufferedImage image(int width, int height, int type, int rgb) {
        BufferedImage image = new BufferedImage(width, height, type);
        for (int i = 0; i < width * height; i++) {
            if (type == BufferedImage.TYPE_BYTE_GRAY) {
                image.getRaster().setSample(i % width, i / width, 0, rgb & 0xff);
            } else {
                image.setRGB(i % width, i / width, rgb);
            }
        }
        return image;
    }

    /** Inserts a segment at the start of a file. */
    public static byte[] with(byte[] file, int marker, byte[] payload) {
        byte[] segment = new byte[4 + payload.length];
        segment[0] = (byte) 0xff;
        segment[1] = (byte) marker;
        segment[2] = (byte) ((2 + payload.length) >> 8);
        segment[3] = (byte) (2 + payload.length);
        System.arraycopy(payload, 0, segment, 4, payload.length);
        return inserted(file, SOI_BYTES, segment);
    }

    /** Adds a part of a color profile to a file. */
    public static byte[] withProfile(byte[] file, int number, int count, byte[] piece) {
        byte[] head = joined(ascii("ICC_PROFILE\0"), new byte[] {(byte) number, (byte) count});
        return with(file, 0xe2, joined(head, piece));
    }

    /** Inserts EXIF data before all other segments. */
    public static byte[] withExif(byte[] file, byte[] tiff) {
        return with(file, 0xe1, joined(ascii("Exif\0\0"), tiff));
    }

    static byte[] inserted(byte[] file, int at, byte[] piece) {
        return joined(joined(Arrays.copyOf(file, at), piece), Arrays.copyOfRange(file, at, file.length));
    }

    public static byte[] joined(byte[] one, byte[] other) {
        byte[] all = Arrays.copyOf(one, one.length + other.length);
        System.arraycopy(other, 0, all, one.length, other.length);
        return all;
    }

    public static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }
}
