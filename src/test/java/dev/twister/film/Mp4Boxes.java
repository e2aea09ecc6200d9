package dev.twister.film;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** Makes MP4 files of the boxes that a check looks at. */
final class Mp4Boxes {
    /** Bytes of each encoded frame. */
    static final int FRAME_BYTES = 10;

    private Mp4Boxes() {}

    /** A film with 1000 time units per frame. */
    static byte[] film(int frames, double rate) {
        return join(box("ftyp", new byte[8]), index(frames, rate), box("mdat", new byte[FRAME_BYTES * frames]));
    }

    static byte[] index(int frames, double rate) {
        ByteBuffer header = ByteBuffer.allocate(24);
        header.putInt(12, (int) Math.round(1000 * rate)).putInt(16, 1000 * frames);
        ByteBuffer sizes = ByteBuffer.allocate(12 + 4 * frames).putInt(8, frames);
        for (int frame = 0; frame < frames; frame++) {
            sizes.putInt(12 + 4 * frame, FRAME_BYTES);
        }
        byte[] samples = box("minf", box("stbl", join(box("stsd", new byte[3]), box("stsz", sizes.array()))));
        return box("moov", box("trak", box("mdia", join(box("mdhd", header.array()), samples))));
    }

    static byte[] box(String type, byte[] content) {
        return ByteBuffer.allocate(8 + content.length)
                .putInt(8 + content.length)
                .put(type.getBytes(StandardCharsets.US_ASCII))
                .put(content)
                .array();
    }

    static byte[] join(byte[]... parts) {
        ByteArrayOutputStream joined = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            joined.writeBytes(part);
        }
        return joined.toByteArray();
    }
}
