package dev.twister.scene.material;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.Rgb;
import dev.twister.scene.property.Copied;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What path tracing alone shows of a material, as the extensions of glTF's material define it.
 *
 * @param dispersion 20 divided by the Abbe number of what transmits, in [0, 20]; 0 for none
 */
@Copied
public record Finish(
        Clearcoat clearcoat,
        Sheen sheen,
        Anisotropy anisotropy,
        Specular specular,
        Film film,
        double dispersion,
        Through through)
        implements FinishCopy.With {
    public static final Finish NONE = new Finish(
            new Clearcoat(0, 0, Optional.empty(), Optional.empty(), Optional.empty()),
            new Sheen(new Rgb(0, 0, 0), 0, Optional.empty(), Optional.empty()),
            new Anisotropy(0, 0, Optional.empty()),
            new Specular(new Rgb(1, 1, 1), Optional.empty(), Optional.empty()),
            new Film(0, 1.3, 100, 400, Optional.empty(), Optional.empty()),
            0,
            new Through(0, new Rgb(1, 1, 1), Optional.empty(), Optional.empty()));

    public Finish {
        requireNonNull(clearcoat, "clearcoat");
        requireNonNull(sheen, "sheen");
        requireNonNull(anisotropy, "anisotropy");
        requireNonNull(specular, "specular");
        requireNonNull(film, "film");
        requireNonNull(through, "through");
    }

    /**
     * A second, dielectric layer on top.
     *
     * @param part in [0, 1]; 0 for none
     * @param roughness in [0, 1]
     * @param map its red channel multiplies the part
     * @param roughnessMap its green channel multiplies the roughness
     * @param normalMap its normals, as those of {@link Maps#normal}; without it, it is smooth
     */
    @Copied
    public record Clearcoat(
            double part,
            double roughness,
            Optional<ImageMap> map,
            Optional<ImageMap> roughnessMap,
            Optional<ImageMap> normalMap)
            implements FinishClearcoatCopy.With {
        public Clearcoat {
            requireNonNull(map, "map");
            requireNonNull(roughnessMap, "roughnessMap");
            requireNonNull(normalMap, "normalMap");
        }
    }

    /**
     * What the fibers of cloth reflect.
     *
     * @param color in [0, 1] per channel; black for none
     * @param roughness in [0, 1]
     * @param colorMap multiplies the color
     * @param roughnessMap its red channel multiplies the roughness
     */
    @Copied
    public record Sheen(Rgb color, double roughness, Optional<ImageMap> colorMap, Optional<ImageMap> roughnessMap)
            implements FinishSheenCopy.With {
        public Sheen {
            requireNonNull(color, "color");
            requireNonNull(colorMap, "colorMap");
            requireNonNull(roughnessMap, "roughnessMap");
        }
    }

    /**
     * How much reflections are stretched in one direction, as on brushed metal.
     *
     * @param strength in [0, 1]; 0 for none
     * @param rotation of that direction, counterclockwise from the right of an image on the surface, in radians
     * @param map red and green are the direction, from -1 at 0 to 1 at 1; blue multiplies the strength
     */
    @Copied
    public record Anisotropy(double strength, double rotation, Optional<ImageMap> map)
            implements FinishAnisotropyCopy.With {
        public Anisotropy {
            requireNonNull(map, "map");
        }
    }

    /**
     * Colors what the index of refraction reflects.
     *
     * @param color factor of what is reflected at the normal, at least 0 per channel
     * @param map its red channel multiplies the material's {@code specular}
     * @param colorMap multiplies the color
     */
    @Copied
    public record Specular(Rgb color, Optional<ImageMap> map, Optional<ImageMap> colorMap)
            implements FinishSpecularCopy.With {
        public Specular {
            requireNonNull(color, "color");
            requireNonNull(map, "map");
            requireNonNull(colorMap, "colorMap");
        }
    }

    /**
     * A thin film, whose interference shows colors.
     *
     * @param part in [0, 1]; 0 for none
     * @param ior its index of refraction, in [1, 4]
     * @param leastThickness in nanometers, where its map is 0
     * @param thickness in nanometers, where its map is 1 or without a map
     * @param map its red channel multiplies the part
     * @param thicknessMap its green channel leads from the least thickness to the other
     */
    @Copied
    public record Film(
            double part,
            double ior,
            double leastThickness,
            double thickness,
            Optional<ImageMap> map,
            Optional<ImageMap> thicknessMap)
            implements FinishFilmCopy.With {
        public Film {
            requireNonNull(map, "map");
            requireNonNull(thicknessMap, "thicknessMap");
        }
    }

    /**
     * Light that passes a thin sheet and leaves it in all directions, as through a leaf or a lampshade.
     *
     * @param part of the matte light, in [0, 1]; 0 for none
     * @param color in [0, 1] per channel
     * @param map its red channel multiplies the part
     * @param colorMap multiplies the color
     */
    @Copied
    public record Through(double part, Rgb color, Optional<ImageMap> map, Optional<ImageMap> colorMap)
            implements FinishThroughCopy.With {
        public Through {
            requireNonNull(color, "color");
            requireNonNull(map, "map");
            requireNonNull(colorMap, "colorMap");
        }
    }

    /** Whether it changes nothing. */
    public boolean isNone() {
        // Most materials have none, which is found at once.
        return equals(NONE) || parts().isEmpty();
    }

    /** The names, as glTF has them, of what it changes. */
    public List<String> parts() {
        return Stream.of(
                        clearcoat.part() == 0 ? "" : "clearcoat",
                        sheen.color().equals(NONE.sheen.color()) ? "" : "sheen",
                        anisotropy.strength() == 0 ? "" : "anisotropy",
                        specular.equals(NONE.specular) ? "" : "specular color",
                        film.part() == 0 ? "" : "iridescence",
                        dispersion == 0 ? "" : "dispersion",
                        through.part() == 0 ? "" : "diffuse transmission")
                .filter(part -> !part.isEmpty())
                .toList();
    }

    /** The maps that it has. */
    public List<ImageMap> maps() {
        return Stream.of(
                        clearcoat.map(),
                        clearcoat.roughnessMap(),
                        clearcoat.normalMap(),
                        sheen.colorMap(),
                        sheen.roughnessMap(),
                        anisotropy.map(),
                        specular.map(),
                        specular.colorMap(),
                        film.map(),
                        film.thicknessMap(),
                        through.map(),
                        through.colorMap())
                .flatMap(Optional::stream)
                .toList();
    }

    /** The same without maps. */
    public Finish withoutMaps() {
        return new Finish(
                NONE.clearcoat.withPart(clearcoat.part()).withRoughness(clearcoat.roughness()),
                NONE.sheen.withColor(sheen.color()).withRoughness(sheen.roughness()),
                anisotropy.withMap(Optional.empty()),
                NONE.specular.withColor(specular.color()),
                film.withMap(Optional.empty()).withThicknessMap(Optional.empty()),
                dispersion,
                NONE.through.withPart(through.part()).withColor(through.color()));
    }
}
