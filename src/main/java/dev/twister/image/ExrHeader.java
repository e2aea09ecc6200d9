package dev.twister.image;

import dev.twister.image.ExrPicture.ExrChannel;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;

/** An OpenEXR file's magic number, version and attributes. */
final class ExrHeader {
    static final int MAGIC = 20_000_630;
    static final int VERSION = 2;
    static final int FLOAT = 2;
    static final byte ZIP = 3;
    private static final byte INCREASING_Y = 0;

    private ExrHeader() {}

    static byte[] bytes(ExrPicture picture, List<ExrChannel> channels) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(buffer(2 * Integer.BYTES).putInt(MAGIC).putInt(VERSION).array());
        attribute(out, "channels", "chlist", channelList(channels));
        attribute(out, "compression", "compression", new byte[] {ZIP});
        attribute(
                out,
                "dataWindow",
                "box2i",
                window(picture.width(), picture.firstRow(), picture.firstRow() + picture.rows() - 1));
        attribute(out, "displayWindow", "box2i", window(picture.width(), 0, picture.height() - 1));
        attribute(out, "lineOrder", "lineOrder", new byte[] {INCREASING_Y});
        attribute(out, "pixelAspectRatio", "float", floats(1));
        attribute(out, "screenWindowCenter", "v2f", floats(0, 0));
        attribute(out, "screenWindowWidth", "float", floats(1));
        picture.provenance().ifPresent(made -> {
            attribute(out, Provenance.SOFTWARE.toLowerCase(Locale.ROOT), "string", ascii(made.software()));
            attribute(out, Provenance.NAME.toLowerCase(Locale.ROOT), "string", ascii(made.text()));
            made.display()
                    .ifPresent(display -> attribute(
                            out, DisplaySettings.NAME.toLowerCase(Locale.ROOT), "string", ascii(display.text())));
        });
        out.write(0);
        return out.toByteArray();
    }

    private static byte[] channelList(List<ExrChannel> channels) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        for (ExrChannel channel : channels) {
            text(out, channel.name());
            // Type, perceptual linearity, three unused bytes, no subsampling.
            out.writeBytes(buffer(4 * Integer.BYTES)
                    .putInt(FLOAT)
                    .putInt(0)
                    .putInt(1)
                    .putInt(1)
                    .array());
        }
        out.write(0);
        return out.toByteArray();
    }

    private static void attribute(ByteArrayOutputStream out, String name, String type, byte[] value) {
        text(out, name);
        text(out, type);
        out.writeBytes(buffer(Integer.BYTES).putInt(value.length).array());
        out.writeBytes(value);
    }

    private static void text(ByteArrayOutputStream out, String text) {
        out.writeBytes(ascii(text));
        out.write(0);
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    /** A window with both corners included. */
    private static byte[] window(int width, int firstRow, int lastRow) {
        return buffer(4 * Integer.BYTES)
                .putInt(0)
                .putInt(firstRow)
                .putInt(width - 1)
                .putInt(lastRow)
                .array();
    }

    private static byte[] floats(float... values) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        for (float value : values) {
            out.writeBytes(buffer(Float.BYTES).putFloat(value).array());
        }
        return out.toByteArray();
    }

    private static ByteBuffer buffer(int bytes) {
        return ExrWriter.buffer(bytes);
    }
}
