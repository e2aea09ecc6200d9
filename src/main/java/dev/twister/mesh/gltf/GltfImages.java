package dev.twister.mesh.gltf;

import dev.twister.files.SystemReason;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.TextureFiles;
import dev.twister.mesh.input.Warnings;
import java.awt.image.BufferedImage;
import java.awt.image.RenderedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** The images of a glTF file, embedded or separate. */
final class GltfImages {
    static final String WEBP = "EXT_texture_webp";

    /** Limits of images that are made of the file's. */
    private static final int MOST_MADE = 200;

    private static final long MOST_TEXELS = 1L << 26;

    private static final String WITHOUT = "; rendered without it";

    private final Path file;
    private final Bytes bytes;
    private final GltfPlace root;
    private final GltfBuffers buffers;
    private final Warnings warnings;
    private final Map<Integer, Optional<Path>> found = new HashMap<>();
    private final Map<Path, byte[]> embedded = new LinkedHashMap<>();
    private final Map<Path, Optional<Path>> alphas = new HashMap<>();
    private long embeddedBytes;
    private int made;

    GltfImages(Path file, Bytes bytes, GltfPlace root, GltfBuffers buffers, Warnings warnings) {
        this.file = file;
        this.bytes = bytes;
        this.root = root;
        this.buffers = buffers;
        this.warnings = warnings;
    }

    /** Embedded images that materials use, by the path in {@link Material#texture}. */
    Map<Path, byte[]> embedded() {
        return embedded;
    }

    /** The image of a texture; empty, with a warning, if it cannot be used. */
    Optional<Path> ofTexture(GltfPlace texture) throws IOException {
        GltfPlace webp = texture.at("extensions").at(WEBP).at("source");
        GltfPlace source = texture.at("source").exists() ? texture.at("source") : webp;
        if (!source.exists()) {
            warnings.add(texture + " has no PNG, JPEG or WebP" + ofExtension(texture) + WITHOUT);
            return Optional.empty();
        }
        GltfPlace images = root.at("images");
        int index = source.index(images);
        Optional<Path> known = found.get(index);
        if (known == null) {
            known = usable(images.at(index), index);
            found.put(index, known);
        }
        return known;
    }

    private static String ofExtension(GltfPlace texture) {
        return texture.at("extensions").names().stream()
                .findFirst()
                .map(name -> " but what " + QuotedText.text(name) + " describes")
                .orElse("");
    }

    private Optional<Path> usable(GltfPlace image, int index) throws IOException {
        try {
            return find(image, index);
        } catch (ClosedByInterruptException canceled) {
            throw canceled;
        } catch (MeshException problem) {
            warnings.add(problem, WITHOUT);
        } catch (IOException problem) {
            warnings.add(image + ": " + SystemReason.of(problem) + WITHOUT);
        }
        return Optional.empty();
    }

    private Optional<Path> find(GltfPlace image, int index) throws IOException {
        GltfPlace uri = image.at("uri");
        if (!uri.exists()) {
            GltfBuffers.Range view = buffers.view(image.at("bufferView").in(root.at("bufferViews")));
            return embed(image, index, view);
        }
        if (GltfBuffers.isData(uri)) {
            byte[] data = GltfBuffers.data(uri);
            return embed(image, index, new GltfBuffers.Range(Bytes.of("", data), 0, data.length));
        }
        return TextureFiles.beside(file, GltfBuffers.name(uri), warnings);
    }

    /**
     * An image of an image's alpha channel, all of whose channels are that; empty if it is opaque.
     *
     * @throws IOException if it cannot be read, or there are too many
     */
    Optional<Path> alphaOf(Path image) throws IOException {
        Optional<Path> known = alphas.get(image);
        if (known == null) {
            known = Optional.empty();
            BufferedImage whole = decoded(image);
            if (whole.getColorModel().hasAlpha()) {
                BufferedImage alpha =
                        new BufferedImage(whole.getWidth(), whole.getHeight(), BufferedImage.TYPE_INT_RGB);
                for (int y = 0; y < alpha.getHeight(); y++) {
                    for (int x = 0; x < alpha.getWidth(); x++) {
                        alpha.setRGB(x, y, (whole.getRGB(x, y) >>> 24) * 0x010101);
                    }
                }
                known = Optional.of(add("alpha-" + alphas.size(), alpha));
            }
            alphas.put(image, known);
        }
        return known;
    }

    /**
     * The texels of one of the file's images.
     *
     * @throws IOException if it cannot be read
     */
    BufferedImage decoded(Path image) throws IOException {
        Optional<byte[]> known = Optional.ofNullable(embedded.get(image));
        byte[] picture = known.isPresent() ? known.get() : Files.readAllBytes(image);
        try (ImageInputStream stream = new MemoryCacheImageInputStream(new ByteArrayInputStream(picture))) {
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

    /**
     * Adds an image that is made of the file's; returns its path.
     *
     * @throws IOException if there are too many
     */
    Path add(String name, RenderedImage picture) throws IOException {
        if (made == MOST_MADE) {
            throw new IOException("is one of more than " + MOST_MADE);
        }
        made++;
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
            ImageIO.write(picture, "png", stream);
        }
        return add(name, bytes.toByteArray());
    }

    private Path add(String name, byte[] picture) {
        Path path = file.resolveSibling(file.getFileName() + "#" + name);
        embedded.put(path, picture);
        return path;
    }

    private Optional<Path> embed(GltfPlace image, int index, GltfBuffers.Range range) throws IOException {
        embeddedBytes += range.length();
        if (embeddedBytes > bytes.length() + buffers.openedBytes()) {
            throw image.failure("shares its bytes with other images, which together are more than the file's");
        }
        byte[] picture = range.bytes().copy(range.start(), (int) range.length());
        TextureFiles.check(picture);
        return Optional.of(add(Integer.toString(index), picture));
    }
}
