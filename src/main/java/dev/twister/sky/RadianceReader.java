package dev.twister.sky;

import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * Reads Radiance pictures. ImageIO plug-ins for them (TwelveMonkeys' imageio-hdr) tone-map to 8 bits unless told not to,
 * fail on flat scanlines and ignore orientation and exposure, while the format itself is small; hence a reader of our own.
 */
final class RadianceReader {
    private RadianceReader() {}

    static Skybox read(ByteBuffer content) throws IOException {
        RadianceHeader header = RadianceHeader.read(content);
        RadianceLayout layout = header.layout();
        int length = layout.scanlineLength();
        checkLength(content.remaining(), layout);

        byte[] scanline = new byte[4 * length];
        if (content.remaining() < layout.scanlines() * RadianceScanlines.fewestBytesWithoutOldRuns(length)) {
            // Old runs can make a picture of any size out of a few bytes: see that they do before making room for it.
            RadianceScanlines rehearsal = new RadianceScanlines(content.duplicate(), length);
            for (int line = 0; line < layout.scanlines(); line++) {
                rehearsal.next(scanline);
            }
        }

        float[] radiance = new float[3 * layout.width() * layout.height()];
        RadianceScanlines scanlines = new RadianceScanlines(content, length);
        RadianceTexels texels = new RadianceTexels(header);
        for (int line = 0; line < layout.scanlines(); line++) {
            scanlines.next(scanline);
            texels.convert(scanline, radiance, layout.texel(line, 0), layout.step());
        }
        return new Skybox(layout.width(), layout.height(), radiance);
    }

    private static void checkLength(long remaining, RadianceLayout layout) throws IOException {
        long needed = layout.scanlines() * RadianceScanlines.fewestBytes(layout.scanlineLength());
        if (remaining < needed) {
            throw new IOException(layout.width() + " x " + layout.height() + " texels take " + needed
                    + " bytes or more, but only " + remaining + " follow the header");
        }
    }
}
