package dev.twister.mesh.gltf;

import dev.twister.mesh.input.Warnings;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.Finish;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.property.FinishProperties;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneLimits;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * What extensions of a glTF material that path tracing alone shows say: clearcoat, sheen, anisotropy, specular,
 * iridescence, dispersion and diffuse transmission.
 */
final class GltfFinish {
    private final GltfPlace extensions;
    private final GltfImages images;
    private final GltfTextures textures;
    private final Warnings warnings;

    /** @param extensions of the material */
    GltfFinish(GltfPlace extensions, GltfImages images, GltfTextures textures, Warnings warnings) {
        this.extensions = extensions;
        this.images = images;
        this.textures = textures;
        this.warnings = warnings;
    }

    Finish finish() throws IOException {
        // Neither may be combined with what follows.
        if (extensions.at("KHR_materials_unlit").exists()
                || extensions.at("KHR_materials_pbrSpecularGlossiness").exists()) {
            return Finish.NONE;
        }
        Finish finish = new Finish(
                clearcoat(extensions.at("KHR_materials_clearcoat")),
                sheen(extensions.at("KHR_materials_sheen")),
                anisotropy(extensions.at("KHR_materials_anisotropy")),
                specular(extensions.at("KHR_materials_specular")),
                film(extensions.at("KHR_materials_iridescence")),
                FinishProperties.DISPERSION.clamp(extensions
                        .at("KHR_materials_dispersion")
                        .at("dispersion")
                        .numberOr(0)),
                through(extensions.at("KHR_materials_diffuse_transmission")));
        return finish.isNone() ? Finish.NONE : finish;
    }

    private Finish.Clearcoat clearcoat(GltfPlace place) throws IOException {
        double part = place.at("clearcoatFactor").unitOr(0);
        return part == 0
                ? Finish.NONE.clearcoat()
                : new Finish.Clearcoat(
                        part,
                        place.at("clearcoatRoughnessFactor").unitOr(0),
                        map(place, "clearcoatTexture"),
                        map(place, "clearcoatRoughnessTexture"),
                        textures.map(place.at("clearcoatNormalTexture"), "scale"));
    }

    private Finish.Sheen sheen(GltfPlace place) throws IOException {
        Rgb color = color(place.at("sheenColorFactor"), 0, SceneLimits.SHARE);
        return color.equals(Finish.NONE.sheen().color())
                ? Finish.NONE.sheen()
                : new Finish.Sheen(
                        color,
                        place.at("sheenRoughnessFactor").unitOr(0),
                        map(place, "sheenColorTexture"),
                        alphaMap(place, "sheenRoughnessTexture"));
    }

    private Finish.Anisotropy anisotropy(GltfPlace place) throws IOException {
        double strength = place.at("anisotropyStrength").unitOr(0);
        return strength == 0
                ? Finish.NONE.anisotropy()
                : new Finish.Anisotropy(
                        strength,
                        Math.IEEEremainder(place.at("anisotropyRotation").numberOr(0), 2 * Math.PI),
                        map(place, "anisotropyTexture"));
    }

    private Finish.Specular specular(GltfPlace place) throws IOException {
        return new Finish.Specular(
                color(place.at("specularColorFactor"), 1, FinishProperties.SPECULAR),
                alphaMap(place, "specularTexture"),
                map(place, "specularColorTexture"));
    }

    private Finish.Film film(GltfPlace place) throws IOException {
        Finish.Film usual = Finish.NONE.film();
        double part = place.at("iridescenceFactor").unitOr(0);
        return part == 0
                ? usual
                : new Finish.Film(
                        part,
                        FinishProperties.FILM_IOR.clamp(
                                place.at("iridescenceIor").numberOr(usual.ior())),
                        thickness(place.at("iridescenceThicknessMinimum"), usual.leastThickness()),
                        thickness(place.at("iridescenceThicknessMaximum"), usual.thickness()),
                        map(place, "iridescenceTexture"),
                        map(place, "iridescenceThicknessTexture"));
    }

    private static double thickness(GltfPlace place, double usual) {
        return FinishProperties.FILM_THICKNESS.clamp(place.numberOr(usual));
    }

    private Finish.Through through(GltfPlace place) throws IOException {
        double part = place.at("diffuseTransmissionFactor").unitOr(0);
        return part == 0
                ? Finish.NONE.through()
                : new Finish.Through(
                        part,
                        color(place.at("diffuseTransmissionColorFactor"), 1, SceneLimits.SHARE),
                        alphaMap(place, "diffuseTransmissionTexture"),
                        map(place, "diffuseTransmissionColorTexture"));
    }

    private static Rgb color(GltfPlace place, double usual, Range range) {
        double[] color = place.numbersOr(usual, usual, usual);
        return new Rgb(range.clamp(color[0]), range.clamp(color[1]), range.clamp(color[2]));
    }

    private Optional<ImageMap> map(GltfPlace place, String texture) throws IOException {
        return textures.map(place.at(texture), "");
    }

    /** A map that glTF has in the alpha channel. */
    private Optional<ImageMap> alphaMap(GltfPlace place, String texture) throws IOException {
        Optional<ImageMap> map = map(place, texture);
        if (map.isPresent()) {
            try {
                Optional<Path> alpha = images.alphaOf(map.get().file());
                return alpha.map(file -> new ImageMap(file, map.get().sampler(), 1));
            } catch (ClosedByInterruptException canceled) {
                throw canceled;
            } catch (IOException problem) {
                warnings.add(place.at(texture) + ": " + problem.getMessage() + "; rendered without it");
            }
        }
        return Optional.empty();
    }
}
