package dev.twister;

import static java.util.Objects.requireNonNull;

import dev.twister.image.Frame;
import dev.twister.image.PngWriter;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;

/**
 * A picture that has been rendered.
 *
 * @param frame 8-bit pixels; those that were not rendered are black
 * @param srgb whether they are sRGB-encoded
 * @param part of the work that was done, from 0 to 1; less than 1 where the rendering was stopped
 */
public record RenderedPicture(Frame frame, boolean srgb, double part) {
    /** Checks that the frame has pixels. */
    public RenderedPicture {
        if (requireNonNull(frame, "frame").isLinear()) {
            throw new IllegalArgumentException("the frame holds linear radiance, but a RenderedPicture needs 8-bit"
                    + " pixels, as of Frame.ofPixels; HdrWriter and ExrWriter write radiance");
        }
    }

    /** A whole picture. */
    public RenderedPicture(Frame frame, boolean srgb) {
        this(frame, srgb, 1);
    }

    /**
     * Writes a PNG file, whole or not at all; an existing file is replaced.
     *
     * @throws IOException where the file cannot be written; the message says why
     */
    public void writePng(Path file) throws IOException {
        PngWriter.write(file, frame.width(), frame.height(), frame.argb(), srgb);
    }

    /** A copy as an image of type {@link BufferedImage#TYPE_INT_RGB}. */
    public BufferedImage toImage() {
        BufferedImage image = new BufferedImage(frame.width(), frame.height(), BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, frame.width(), frame.height(), frame.argb(), 0, frame.width());
        return image;
    }
}
