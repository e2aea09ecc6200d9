package dev.twister.mesh.gltf;

import java.awt.image.BufferedImage;
import java.awt.image.RenderedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Converted textures of a glTF file with KHR_materials_pbrSpecularGlossiness, each made once. */
final class GlossyImages {
    private static final int MOST = 100;
    private static final long MOST_TEXELS = 1L << 26;

    private final GltfImages images;
    private final Map<Key, Converted> made = new HashMap<>();

    /** Paths of images that count as embedded in the file. */
    record Converted(Path color, Path metal) {}

    private record Key(Optional<Path> diffuse, Path glossy, GlossyTexels.Factors factors) {}

    GlossyImages(GltfImages images) {
        this.images = images;
    }

    /**
     * Converts two textures.
     *
     * @throws IOException if one cannot be read, or there are too many
     */
    Converted of(Optional<Path> diffuse, Path glossy, GlossyTexels.Factors factors) throws IOException {
        Key key = new Key(diffuse, glossy, factors);
        Converted known = made.get(key);
        if (known == null) {
            if (made.size() == MOST) {
                throw new IOException("is one of more than " + MOST);
            }
            Optional<BufferedImage> shown =
                    diffuse.isPresent() ? Optional.of(decoded(diffuse.get())) : Optional.empty();
            GlossyTexels texels = GlossyTexels.of(shown, decoded(glossy), factors);
            String name = "converted-" + made.size();
            known = new Converted(
                    images.add(name + "-color", png(texels.color())), images.add(name + "-metal", png(texels.metal())));
            made.put(key, known);
        }
        return known;
    }

    private BufferedImage decoded(Path image) throws IOException {
        Optional<byte[]> embedded = Optional.ofNullable(images.embedded().get(image));
        byte[] bytes = embedded.isPresent() ? embedded.get() : Files.readAllBytes(image);
        try (ImageInputStream stream = new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
            if (!readers.hasNext()) {
                throw new IOException("is of a kind that this Java runtime cannot read");
            }
            ImageReader reader = readers.next();
            try {
                reader.setInput(stream, true, true);
                if ((long) reader.getWidth(0) * reader.getHeight(0) > MOST_TEXELS) {
                    throw new IOException("has more than " + MOST_TEXELS + " texels");
                }
                return reader.read(0);
            } catch (IllegalArgumentException | IndexOutOfBoundsException | IllegalStateException damaged) {
                // ImageIO's decoders answer some damaged files so.
                throw new IOException("is damaged", damaged);
            } finally {
                reader.dispose();
            }
        }
    }

    private static byte[] png(RenderedImage image) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
            ImageIO.write(image, "png", stream);
        }
        return bytes.toByteArray();
    }
}
