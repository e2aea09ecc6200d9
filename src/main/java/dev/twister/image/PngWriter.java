package dev.twister.image;

import dev.twister.files.WholeFile;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Optional;
import javax.imageio.IIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Writes 8-bit pixels as a PNG file. */
public final class PngWriter {
    private static final int RED_MASK = 0xff0000;
    private static final int GREEN_MASK = 0x00ff00;
    private static final int BLUE_MASK = 0x0000ff;
    private static final int ALPHA_MASK = 0xff000000;

    private static final String FORMAT = "javax_imageio_png_1.0";

    /** 1.0, in units of 1/100,000. */
    private static final String LINEAR_GAMMA = "100000";

    private PngWriter() {}

    /**
     * Writes an opaque 24-bit RGB picture; on failure the file is unchanged. The array is not copied, and the file is
     * streamed, so that little memory is needed besides the array.
     *
     * @param width pixels in a row, 1 or more
     * @param height rows, 1 or more
     * @param argb {@code width * height} ints, 0xAARRGGBB, row by row from the top; alpha is ignored
     * @param srgb whether the channels are sRGB-encoded; linear ones are marked by a gAMA chunk of 1.0
     * @throws IllegalArgumentException if the array has another length
     * @throws IOException as {@link WholeFile#write}
     */
    public static void write(Path file, int width, int height, int[] argb, boolean srgb) throws IOException {
        BufferedImage image = image(width, height, argb, false);
        WholeFile.write(file, out -> write(out, image, srgb, Optional.empty()));
    }

    /**
     * As above, with the provenance as text chunks.
     *
     * @param alpha whether the pixels' alpha is written, for colors that are not multiplied by it; ignored if false
     */
    public static void write(Path file, int width, int height, int[] argb, boolean srgb, boolean alpha, Provenance made)
            throws IOException {
        BufferedImage image = image(width, height, argb, alpha);
        WholeFile.write(file, out -> write(out, image, srgb, Optional.of(made)));
    }

    /**
     * As above, to a stream, which stays open.
     *
     * @throws IOException the failure of the stream
     */
    public static void write(
            OutputStream out, int width, int height, int[] argb, boolean srgb, boolean alpha, Provenance made)
            throws IOException {
        write(out, image(width, height, argb, alpha), srgb, Optional.of(made));
        out.flush();
    }

    private static void write(OutputStream out, BufferedImage image, boolean srgb, Optional<Provenance> made)
            throws IOException {
        // ImageIO's default stream would write the picture to a temporary file first.
        try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
            write(image, srgb, made, stream);
        }
    }

    private static BufferedImage image(int width, int height, int[] argb, boolean alpha) {
        if (width < 1 || height < 1 || argb.length != (long) width * height) {
            throw new IllegalArgumentException("a picture of " + width + " x " + height + " pixels needs "
                    + (long) width * height + " ints, not " + argb.length);
        }
        WritableRaster raster = Raster.createPackedRaster(
                new DataBufferInt(argb, argb.length),
                width,
                height,
                width,
                alpha
                        ? new int[] {RED_MASK, GREEN_MASK, BLUE_MASK, ALPHA_MASK}
                        : new int[] {RED_MASK, GREEN_MASK, BLUE_MASK},
                null);
        DirectColorModel model = alpha
                ? new DirectColorModel(32, RED_MASK, GREEN_MASK, BLUE_MASK, ALPHA_MASK)
                : new DirectColorModel(24, RED_MASK, GREEN_MASK, BLUE_MASK);
        return new BufferedImage(model, raster, false, null);
    }

    private static void write(BufferedImage image, boolean srgb, Optional<Provenance> made, ImageOutputStream stream)
            throws IOException {
        ImageTypeSpecifier type = ImageTypeSpecifier.createFromRenderedImage(image);
        Iterator<ImageWriter> writers = ImageIO.getImageWriters(type, "png");
        if (!writers.hasNext()) {
            throw new IOException("this Java runtime has no PNG writer");
        }
        ImageWriter writer = writers.next();
        try {
            writer.setOutput(stream);
            IIOMetadata metadata = writer.getDefaultImageMetadata(type, null);
            if (!srgb) {
                metadata.mergeTree(FORMAT, linearGamma());
            }
            if (made.isPresent()) {
                metadata.mergeTree(FORMAT, texts(made.get()));
            }
            writer.write(new IIOImage(image, null, metadata));
        } catch (IIOException failure) {
            // Its message does not say why.
            throw failure.getCause() instanceof IOException cause ? cause : failure;
        } finally {
            writer.dispose();
        }
    }

    private static IIOMetadataNode texts(Provenance made) {
        IIOMetadataNode texts = new IIOMetadataNode("tEXt");
        texts.appendChild(text(Provenance.SOFTWARE, made.software()));
        texts.appendChild(text(Provenance.NAME, made.text()));
        IIOMetadataNode root = new IIOMetadataNode(FORMAT);
        root.appendChild(texts);
        return root;
    }

    private static IIOMetadataNode text(String keyword, String value) {
        IIOMetadataNode entry = new IIOMetadataNode("tEXtEntry");
        entry.setAttribute("keyword", keyword);
        entry.setAttribute("value", value);
        return entry;
    }

    private static IIOMetadataNode linearGamma() {
        IIOMetadataNode gamma = new IIOMetadataNode("gAMA");
        gamma.setAttribute("value", LINEAR_GAMMA);
        IIOMetadataNode root = new IIOMetadataNode(FORMAT);
        root.appendChild(gamma);
        return root;
    }
}
