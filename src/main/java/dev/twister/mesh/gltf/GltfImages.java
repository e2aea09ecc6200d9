package dev.twister.mesh.gltf;

import dev.twister.files.SystemReason;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.TextureFiles;
import dev.twister.mesh.input.Warnings;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** The images of a glTF file, embedded or separate. */
final class GltfImages {
    static final String WEBP = "EXT_texture_webp";

    private static final String WITHOUT = "; rendered without it";

    private final Path file;
    private final Bytes bytes;
    private final GltfPlace root;
    private final GltfBuffers buffers;
    private final Warnings warnings;
    private final Map<Integer, Optional<Path>> found = new HashMap<>();
    private final Map<Path, byte[]> embedded = new LinkedHashMap<>();
    private long embeddedBytes;

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

    /** Adds an image that is made of the file's; returns its path. */
    Path add(String name, byte[] picture) {
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
