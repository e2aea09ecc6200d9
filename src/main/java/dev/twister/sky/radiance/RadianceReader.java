package dev.twister.sky.radiance;

import dev.twister.sky.Skybox;
import dev.twister.sky.image.FileBytes;
import dev.twister.sky.image.FileCursor;
import dev.twister.sky.image.ScanOrder;
import java.io.IOException;

/**
 * Reads Radiance pictures. ImageIO plug-ins for them (TwelveMonkeys' imageio-hdr) tone-map to 8 bits unless told not
 * to, fail on flat scanlines and ignore orientation and exposure, while the format itself is small; hence a reader of
 * our own.
 */
public final class RadianceReader {
    private RadianceReader() {}

    public static Skybox read(FileBytes file) throws IOException {
        FileCursor content = new FileCursor(file);
        RadianceHeader header = RadianceHeader.read(content);
        ScanOrder order = header.order();
        int length = order.scanlineLength();
        checkLength(content.remaining(), order);

        byte[] scanline = new byte[4 * length];
        if (content.remaining() < order.scanlines() * RadianceScanlines.fewestBytesWithoutOldRuns(length)) {
            // Old runs can make a picture of any size out of a few bytes: see that they do before making room for it.
            RadianceScanlines rehearsal = new RadianceScanlines(content.copy(), length);
            for (int line = 0; line < order.scanlines(); line++) {
                rehearsal.next(scanline);
            }
        }

        float[] radiance = new float[3 * order.width() * order.height()];
        RadianceScanlines scanlines = new RadianceScanlines(content, length);
        RadianceTexels texels = new RadianceTexels(header);
        for (int line = 0; line < order.scanlines(); line++) {
            scanlines.next(scanline);
            texels.convert(scanline, radiance, order.texel(line, 0), order.step());
        }
        return new Skybox(order.width(), order.height(), radiance);
    }

    private static void checkLength(long remaining, ScanOrder order) throws IOException {
        long needed = order.scanlines() * RadianceScanlines.fewestBytes(order.scanlineLength());
        if (remaining < needed) {
            throw new IOException(order.width() + " x " + order.height() + " texels take " + needed
                    + " bytes or more, but only " + remaining + " follow the header");
        }
    }
}
