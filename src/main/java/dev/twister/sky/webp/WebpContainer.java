package dev.twister.sky.webp;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;

/**
 * The chunks of a WebP file (RFC 9649, section 2), and its picture; of an animation the first frame on its canvas.
 * Equal to libwebp's texels.
 */
public final class WebpContainer {
    private static final int FILE_HEADER = 12;
    private static final int CHUNK_HEADER = 8;
    private static final int EXTENDED_BYTES = 10;
    private static final int FRAME_HEADER = 16;
    private static final int ANIMATED = 0x02;

    /** Part of a file's bytes. */
    private record Chunk(String type, int from, int to) {
        int length() {
            return to - from;
        }
    }

    /** Chunks that may be one picture: those of a file, or of an animation's frame. */
    private record Picture(Optional<Chunk> alpha, Chunk texels) {}

    /** The canvas, and where on it the picture is. */
    private record Place(int width, int height, int x, int y) {}

    private final byte[] file;
    private final Optional<Chunk> profile;
    private final Optional<Chunk> exif;
    private final Picture picture;
    private final Place place;
    private final WebpImage size;

    /**
     * Reads the chunks' headers.
     *
     * @param file a whole file that starts with {@code RIFF}
     * @throws IOException if it is damaged or incomplete
     */
    public WebpContainer(byte[] file) throws IOException {
        this.file = file;
        long end = file.length < FILE_HEADER ? 0 : CHUNK_HEADER + Integer.toUnsignedLong(number(4, 4));
        WebpDamage.check(end >= FILE_HEADER + CHUNK_HEADER, "its length is missing");
        if (end > file.length) {
            throw WebpDamage.truncated();
        }
        Chunk all = new Chunk("RIFF", FILE_HEADER, (int) end);
        Optional<Chunk> extended = find(all, "VP8X").filter(chunk -> chunk.from() == FILE_HEADER + CHUNK_HEADER);
        WebpDamage.check(
                extended.isEmpty() || extended.get().length() >= EXTENDED_BYTES, "its VP8X chunk is too short");
        boolean animated = extended.isPresent() && (number(extended.get().from(), 1) & ANIMATED) != 0;
        profile = extended.isPresent() ? find(all, "ICCP") : Optional.empty();
        exif = extended.isPresent() ? find(all, "EXIF") : Optional.empty();
        if (animated) {
            Chunk frame = find(all, "ANMF").orElseThrow(() -> WebpDamage.damaged("an animation without a frame"));
            WebpDamage.check(frame.length() > FRAME_HEADER, "a frame that is too short");
            picture = picture(new Chunk(frame.type(), frame.from() + FRAME_HEADER, frame.to()));
        } else {
            picture = picture(all);
        }
        size = size(picture.texels());
        place = animated ? framePlace(extended.get()) : new Place(size.width(), size.height(), 0, 0);
        if (extended.isPresent() && !animated) {
            WebpDamage.check(
                    number(extended.get().from() + 4, 3) + 1 == size.width()
                            && number(extended.get().from() + 7, 3) + 1 == size.height(),
                    "its VP8X chunk has another size than the picture");
        }
    }

    /** Texels in a row. */
    public int width() {
        return place.width();
    }

    /** Rows. */
    public int height() {
        return place.height();
    }

    /** The ICC profile. */
    public Optional<byte[]> profile() {
        return profile.map(this::bytes);
    }

    /** The TIFF structure of the EXIF data. */
    public Optional<byte[]> exif() {
        return exif.map(this::bytes)
                .map(data -> data.length > 6 && new String(data, 0, 4, StandardCharsets.US_ASCII).equals("Exif")
                        ? Arrays.copyOfRange(data, 6, data.length)
                        : data);
    }

    /**
     * Decodes the picture. Memory and time are bounded by its size and the file's length.
     *
     * @throws IOException if it is damaged or incomplete
     */
    public WebpImage decode() throws IOException {
        WebpImage image;
        try {
            image = decodePicture();
        } catch (ArrayIndexOutOfBoundsException impossible) {
            throw new IOException("a damaged WebP (a number is out of range)", impossible);
        }
        if (place.width() == image.width() && place.height() == image.height()) {
            return image;
        }
        int[] canvas = new int[Math.multiplyExact(place.width(), place.height())];
        for (int row = 0; row < image.height(); row++) {
            int to = (place.y() + row) * place.width() + place.x();
            for (int column = 0; column < image.width(); column++) {
                int texel = image.argb()[row * image.width() + column];
                canvas[to + column] = image.hasAlpha() ? texel : texel | 0xff << 24;
            }
        }
        return new WebpImage(place.width(), place.height(), canvas, true);
    }

    private WebpImage decodePicture() throws IOException {
        Chunk texels = picture.texels();
        if (texels.type().equals("VP8L")) {
            LosslessBits bits = new LosslessBits(file, texels.from() + Lossless.HEADER_BYTES, texels.to());
            int[] argb = Lossless.decode(bits, size.width(), size.height());
            return new WebpImage(size.width(), size.height(), argb, size.hasAlpha());
        }
        int[] argb = Vp8Frame.decode(file, texels.from(), texels.to());
        if (picture.alpha().isPresent()) {
            Chunk alpha = picture.alpha().get();
            WebpAlpha.put(Arrays.copyOfRange(file, alpha.from(), alpha.to()), size.width(), size.height(), argb);
        }
        return new WebpImage(size.width(), size.height(), argb, picture.alpha().isPresent());
    }

    private Place framePlace(Chunk extended) throws IOException {
        Chunk frame = new Chunk("ANMF", picture.alpha().orElse(picture.texels()).from(), 0);
        int header = frame.from() - CHUNK_HEADER - FRAME_HEADER;
        Place found = new Place(
                number(extended.from() + 4, 3) + 1,
                number(extended.from() + 7, 3) + 1,
                2 * number(header, 3),
                2 * number(header + 3, 3));
        WebpDamage.check(
                found.x() + size.width() <= found.width() && found.y() + size.height() <= found.height(),
                "a frame beyond the canvas");
        return found;
    }

    private Picture picture(Chunk parent) throws IOException {
        Optional<Chunk> lossy = find(parent, "VP8 ");
        if (lossy.isPresent()) {
            return new Picture(
                    find(parent, "ALPH")
                            .filter(chunk -> chunk.from() < lossy.get().from()),
                    lossy.get());
        }
        return new Picture(
                Optional.empty(),
                find(parent, "VP8L").orElseThrow(() -> WebpDamage.damaged("it has no picture of VP8 or VP8L")));
    }

    /** The width, height and alpha of a picture; without texels. */
    private WebpImage size(Chunk texels) throws IOException {
        if (texels.type().equals("VP8L")) {
            WebpDamage.check(
                    texels.length() > Lossless.HEADER_BYTES && number(texels.from(), 1) == Lossless.SIGNATURE,
                    "no VP8L");
            int bits = number(texels.from() + 1, 4);
            WebpDamage.check(bits >>> 29 == 0, "an unknown version of VP8L");
            return new WebpImage((bits & 0x3fff) + 1, (bits >>> 14 & 0x3fff) + 1, new int[0], (bits >>> 28 & 1) == 1);
        }
        WebpDamage.check(texels.length() > Vp8Frame.HEADER_BYTES, "a VP8 frame that is too short");
        int width = number(texels.from() + 6, 2) & 0x3fff;
        int height = number(texels.from() + 8, 2) & 0x3fff;
        WebpDamage.check(width > 0 && height > 0, "a picture of no texels");
        return new WebpImage(width, height, new int[0], picture.alpha().isPresent());
    }

    /** The first chunk of a type among those in a parent. */
    private Optional<Chunk> find(Chunk parent, String type) throws IOException {
        long at = parent.from();
        while (at + CHUNK_HEADER <= parent.to()) {
            int from = (int) at + CHUNK_HEADER;
            long length = Integer.toUnsignedLong(number((int) at + 4, 4));
            if (from + length > parent.to()) {
                throw WebpDamage.truncated();
            }
            String found = new String(file, (int) at, 4, StandardCharsets.ISO_8859_1);
            if (found.equals(type)) {
                return Optional.of(new Chunk(type, from, from + (int) length));
            }
            at = from + length + (length & 1);
        }
        return Optional.empty();
    }

    private byte[] bytes(Chunk chunk) {
        return Arrays.copyOfRange(file, chunk.from(), chunk.to());
    }

    /** A number of 1 to 4 bytes, the lowest first. */
    private int number(int at, int bytes) {
        int number = 0;
        for (int i = 0; i < bytes; i++) {
            number |= Byte.toUnsignedInt(file[at + i]) << (8 * i);
        }
        return number;
    }

    /** The alpha of a lossy picture (RFC 9649, section 2.7.1.2). */
    private static final class WebpAlpha {
        private static final int PLAIN = 0;
        private static final int LOSSLESS = 1;
        private static final int HORIZONTAL = 1;
        private static final int VERTICAL = 2;
        private static final int GRADIENT = 3;

        private WebpAlpha() {}

        /** Decodes a chunk's data into the alpha of texels. */
        static void put(byte[] chunk, int width, int height, int[] argb) throws IOException {
            WebpDamage.check(chunk.length > 1 && (chunk[0] & 0xc0) == 0, "its alpha has no data");
            int compression = chunk[0] & 3;
            int filter = chunk[0] >> 2 & 3;
            byte[] alpha = new byte[width * height];
            if (compression == PLAIN) {
                if (chunk.length - 1 < alpha.length) {
                    throw WebpDamage.truncated();
                }
                System.arraycopy(chunk, 1, alpha, 0, alpha.length);
            } else {
                WebpDamage.check(compression == LOSSLESS, "an unknown compression of its alpha");
                int[] green = Lossless.decode(new LosslessBits(chunk, 1, chunk.length), width, height);
                for (int i = 0; i < alpha.length; i++) {
                    alpha[i] = (byte) (green[i] >> 8);
                }
            }
            unfilter(alpha, width, filter);
            for (int i = 0; i < alpha.length; i++) {
                argb[i] = (argb[i] & 0xffffff) | alpha[i] << 24;
            }
        }

        private static void unfilter(byte[] alpha, int width, int filter) {
            for (int i = 1; filter != 0 && i < alpha.length; i++) {
                alpha[i] += (byte) prediction(alpha, i, width, filter);
            }
        }

        private static int prediction(byte[] alpha, int i, int width, int filter) {
            boolean top = i < width;
            boolean left = i % width == 0;
            if (top || (!left && filter == HORIZONTAL)) {
                return alpha[i - 1];
            }
            if (left || filter == VERTICAL) {
                return alpha[i - width];
            }
            return filter == GRADIENT
                    ? Math.clamp(
                            (alpha[i - 1] & 0xff) + (alpha[i - width] & 0xff) - (alpha[i - width - 1] & 0xff), 0, 255)
                    : 0;
        }
    }

    /**
     * A decoded picture.
     *
     * @param argb {@code width * height} texels, row by row from the top: alpha in the highest 8 bits, then red, green,
     *     blue; not premultiplied
     * @param hasAlpha whether the file says that texels may be transparent; otherwise alpha means nothing
     */
    @SuppressWarnings("ArrayRecordComponent") // read in place
    public record WebpImage(int width, int height, int[] argb, boolean hasAlpha) {}
}
