package dev.twister.scene.material;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The maps of a material besides its texture.
 *
 * @param texture how the material's texture is read
 * @param emission multiplies the emission
 * @param roughness its green channel multiplies the roughness
 * @param metallic its blue channel multiplies the metallic part
 * @param normal normals in tangent space, as glTF has them, or heights if it is gray
 * @param occlusion its red channel multiplies the ambient light
 * @param transmission its red channel multiplies the transmission
 * @param alpha its red channel is the opacity; without it, that is the texture's alpha channel
 */
@Copied
public record Maps(
        Sampler texture,
        Optional<ImageMap> emission,
        Optional<ImageMap> roughness,
        Optional<ImageMap> metallic,
        Optional<ImageMap> normal,
        Optional<ImageMap> occlusion,
        Optional<ImageMap> transmission,
        Optional<ImageMap> alpha)
        implements MapsCopy.With {
    public static final Maps NONE = new Maps(
            Sampler.DEFAULT,
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty());

    public Maps {
        requireNonNull(texture, "texture");
        requireNonNull(emission, "emission");
        requireNonNull(roughness, "roughness");
        requireNonNull(metallic, "metallic");
        requireNonNull(normal, "normal");
        requireNonNull(occlusion, "occlusion");
        requireNonNull(transmission, "transmission");
        requireNonNull(alpha, "alpha");
    }

    /** Those that it has. */
    public List<ImageMap> all() {
        return Stream.of(emission, roughness, metallic, normal, occlusion, transmission, alpha)
                .flatMap(Optional::stream)
                .toList();
    }

    public Maps withEmission(ImageMap newEmission) {
        return withEmission(Optional.of(newEmission));
    }

    public Maps withRoughness(ImageMap newRoughness) {
        return withRoughness(Optional.of(newRoughness));
    }

    public Maps withMetallic(ImageMap newMetallic) {
        return withMetallic(Optional.of(newMetallic));
    }

    public Maps withNormal(ImageMap newNormal) {
        return withNormal(Optional.of(newNormal));
    }

    public Maps withOcclusion(ImageMap newOcclusion) {
        return withOcclusion(Optional.of(newOcclusion));
    }

    public Maps withTransmission(ImageMap newTransmission) {
        return withTransmission(Optional.of(newTransmission));
    }

    public Maps withAlpha(ImageMap newAlpha) {
        return withAlpha(Optional.of(newAlpha));
    }

    public Maps withoutAlpha() {
        return withAlpha(Optional.empty());
    }
}
