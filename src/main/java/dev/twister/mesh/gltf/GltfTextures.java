package dev.twister.mesh.gltf;

import dev.twister.mesh.input.TextureLayout;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Sampler;
import dev.twister.scene.material.Wrap;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The textures of one glTF material, and the texture coordinates that place them. */
final class GltfTextures {
    private static final int CLAMP_TO_EDGE = 33071;
    private static final int MIRRORED_REPEAT = 33648;
    private static final int REPEAT = 10497;
    private static final int NEAREST = 9728;

    private final GltfPlace root;
    private final GltfImages images;
    private final List<Coordinates> coordinates = new ArrayList<>();

    /**
     * Texture coordinates of vertices.
     *
     * @param set the file's set
     * @param layout transform of them
     */
    record Coordinates(int set, TextureLayout layout) {}

    GltfTextures(GltfPlace root, GltfImages images) {
        this.root = root;
        this.images = images;
    }

    /** The distinct texture coordinates, by {@link Sampler#coordinates}; at least one. */
    List<Coordinates> coordinates() {
        return coordinates.isEmpty() ? List.of(new Coordinates(0, TextureLayout.PLAIN)) : List.copyOf(coordinates);
    }

    /**
     * A map; empty if the material has none, or its image cannot be used.
     *
     * @param texture the place of a texture's info
     * @param scale the name of its factor, if it has one
     */
    Optional<ImageMap> map(GltfPlace texture, String scale) throws IOException {
        if (!texture.exists()) {
            return Optional.empty();
        }
        GltfPlace source = texture.at("index").in(root.at("textures"));
        Optional<Path> file = images.ofTexture(source);
        if (file.isEmpty()) {
            return Optional.empty();
        }
        GltfPlace transform = texture.at("extensions").at("KHR_texture_transform");
        GltfPlace set = transform.at("texCoord").exists() ? transform.at("texCoord") : texture.at("texCoord");
        Coordinates used = new Coordinates((int) Math.min(set.countOr(0), Integer.MAX_VALUE), layout(transform));
        if (!coordinates.contains(used)) {
            coordinates.add(used);
        }
        Sampler sampler = sampler(source, coordinates.indexOf(used));
        return Optional.of(new ImageMap(file.get(), sampler, texture.at(scale).numberOr(1)));
    }

    private static TextureLayout layout(GltfPlace transform) {
        double[] offset = transform.at("offset").numbersOr(0, 0);
        double[] scale = transform.at("scale").numbersOr(1, 1);
        double rotation = transform.at("rotation").numberOr(0);
        return new TextureLayout(scale[0], scale[1], Math.cos(rotation), Math.sin(rotation), offset[0], offset[1]);
    }

    private Sampler sampler(GltfPlace texture, int coordinate) {
        if (!texture.at("sampler").exists()) {
            return new Sampler(Wrap.REPEAT, Wrap.REPEAT, false, coordinate);
        }
        GltfPlace sampler = texture.at("sampler").in(root.at("samplers"));
        return new Sampler(
                wrap(sampler.at("wrapS")),
                wrap(sampler.at("wrapT")),
                sampler.at("magFilter").countOr(0) == NEAREST,
                coordinate);
    }

    private static Wrap wrap(GltfPlace mode) {
        return switch ((int) mode.countOr(REPEAT)) {
            case CLAMP_TO_EDGE -> Wrap.CLAMP;
            case MIRRORED_REPEAT -> Wrap.MIRROR;
            default -> Wrap.REPEAT;
        };
    }
}
