package dev.twister.scene.property;

import static dev.twister.scene.property.Property.color;
import static dev.twister.scene.property.Property.decimal;
import static dev.twister.scene.property.Property.image;
import static dev.twister.scene.property.Slide.linear;

import dev.twister.scene.Integrator;
import dev.twister.scene.Material;
import dev.twister.scene.material.Finish;
import dev.twister.scene.material.Finish.Anisotropy;
import dev.twister.scene.material.Finish.Clearcoat;
import dev.twister.scene.material.Finish.Film;
import dev.twister.scene.material.Finish.Sheen;
import dev.twister.scene.material.Finish.Specular;
import dev.twister.scene.material.Finish.Through;
import dev.twister.scene.material.ImageMap;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Stream;

/** The properties of a material that path tracing alone shows, each as the glTF extension of its name has it. */
public final class FinishProperties {
    public static final Range SPECULAR = new Range(0, 100);
    public static final Range FILM_IOR = new Range(1, 4);
    public static final Range FILM_THICKNESS = new Range(0, 10_000, "nanometers");
    public static final Range DISPERSION = new Range(0, 20);

    private static final Range TURN = new Range(-1000, 1000, "radians");

    static final List<Property<Material, ?>> NUMBERS = Stream.of(
                    of(
                            Finish::clearcoat,
                            Finish::withClearcoat,
                            List.of(
                                    decimal("clearcoat", SceneLimits.SHARE, Clearcoat::part, Clearcoat::withPart)
                                            .means(
                                                    "in path tracing, without `reflectivity`, as all that follow: a second layer"
                                                            + " on top, of the index 1.5")
                                            .row("Clear coat", "A second, clear layer on top, as of varnish.", ""),
                                    decimal(
                                                    "clearcoatRoughness",
                                                    SceneLimits.SHARE,
                                                    Clearcoat::roughness,
                                                    Clearcoat::withRoughness)
                                            .means("its roughness")
                                            .row("Clear coat roughness", "How rough the clear coat is.", ""))),
                    of(
                            Finish::sheen,
                            Finish::withSheen,
                            List.of(
                                    color("sheenColor", SceneLimits.SHARE, Sheen::color, Sheen::withColor)
                                            .means(
                                                    "what the fibers of cloth reflect, most at the edges; black for none")
                                            .row("Sheen", "What the fibers of cloth reflect; black for none.", ""),
                                    decimal("sheenRoughness", SceneLimits.SHARE, Sheen::roughness, Sheen::withRoughness)
                                            .means("how much the fibers are in disorder")
                                            .row("Sheen roughness", "How much the fibers are in disorder.", ""))),
                    of(
                            Finish::anisotropy,
                            Finish::withAnisotropy,
                            List.of(
                                    decimal(
                                                    "anisotropy",
                                                    SceneLimits.SHARE,
                                                    Anisotropy::strength,
                                                    Anisotropy::withStrength)
                                            .means(
                                                    "how much rough reflections are stretched in one direction, as on brushed"
                                                            + " metal")
                                            .row(
                                                    "Anisotropy",
                                                    "How much rough reflections are stretched in one direction.",
                                                    ""),
                                    decimal("anisotropyRotation", TURN, Anisotropy::rotation, Anisotropy::withRotation)
                                            .means(
                                                    "that direction, counterclockwise from the right of an image on the surface")
                                            .row(
                                                    "Anisotropy rotation",
                                                    "The direction of the stretched reflections, in radians.",
                                                    "")
                                            .slide(linear(-3.15, 3.15, 2, "rad")))),
                    of(
                            Finish::specular,
                            Finish::withSpecular,
                            List.of(color("specularColor", SPECULAR, Specular::color, Specular::withColor)
                                    .means("color of what `ior` reflects at the normal; not of metals")
                                    .row("Specular color", "Color of what the index of refraction reflects.", ""))),
                    of(
                            Finish::film,
                            Finish::withFilm,
                            List.of(
                                    decimal("iridescence", SceneLimits.SHARE, Film::part, Film::withPart)
                                            .means(
                                                    "a thin film, whose colors change with the angle, as on a soap bubble")
                                            .row("Iridescence", "A thin film, whose colors change with the angle.", ""),
                                    decimal("iridescenceIor", FILM_IOR, Film::ior, Film::withIor)
                                            .means("the film's index of refraction")
                                            .row("Iridescence index", "The film's index of refraction.", "")
                                            .slide(linear(1, 2.5, 2, "")),
                                    decimal(
                                                    "iridescenceThicknessMinimum",
                                                    FILM_THICKNESS,
                                                    Film::leastThickness,
                                                    Film::withLeastThickness)
                                            .means("the film's thickness where `iridescenceThicknessMap` is 0")
                                            .row("Film from", "The film's thickness where its map is 0.", "")
                                            .slide(linear(0, 1200, 0, "nm")),
                                    decimal(
                                                    "iridescenceThickness",
                                                    FILM_THICKNESS,
                                                    Film::thickness,
                                                    Film::withThickness)
                                            .means("the film's thickness where that map is 1, or without it")
                                            .row("Film thickness", "The film's thickness.", "")
                                            .slide(linear(0, 1200, 0, "nm")))),
                    Stream.<Property<Finish, ?>>of(decimal(
                                    "dispersion", DISPERSION, Finish::dispersion, Finish::withDispersion)
                            .means("how much `ior` changes with the color of light: 20 divided by the Abbe number")
                            .row("Dispersion", "How much glass parts the colors: 20 divided by its Abbe number.", "")
                            .slide(linear(0, 2, 2, ""))),
                    of(
                            Finish::through,
                            Finish::withThrough,
                            List.of(
                                    decimal("diffuseTransmission", SceneLimits.SHARE, Through::part, Through::withPart)
                                            .means(
                                                    "part of the matte light that passes a thin sheet and leaves it in all"
                                                            + " directions, as through a leaf")
                                            .row(
                                                    "Diffuse transmission",
                                                    "Part of the matte light that passes, as through a leaf or a lampshade.",
                                                    ""),
                                    color(
                                                    "diffuseTransmissionColor",
                                                    SceneLimits.SHARE,
                                                    Through::color,
                                                    Through::withColor)
                                            .means("color of that light")
                                            .row("Diffuse transmission color", "Color of the light that passes.", ""))))
            .flatMap(properties -> properties)
            .<Property<Material, ?>>map(property -> ofMaterial(property.animated()))
            .toList();

    /** In the order in which their files are read. */
    static final List<Property<Material, Optional<Path>>> IMAGES = Stream.of(
                    map("clearcoatMap", Finish::clearcoat, Finish::withClearcoat, Clearcoat::map, Clearcoat::withMap)
                            .means("an image whose red channel multiplies `clearcoat`")
                            .row("Clear coat map", "A picture whose red channel multiplies the clear coat.", ""),
                    map(
                                    "clearcoatRoughnessMap",
                                    Finish::clearcoat,
                                    Finish::withClearcoat,
                                    Clearcoat::roughnessMap,
                                    Clearcoat::withRoughnessMap)
                            .means("an image whose green channel multiplies `clearcoatRoughness`")
                            .row("Clear coat roughness map", "A picture whose green channel multiplies it.", ""),
                    map(
                                    "clearcoatNormalMap",
                                    Finish::clearcoat,
                                    Finish::withClearcoat,
                                    Clearcoat::normalMap,
                                    Clearcoat::withNormalMap)
                            .means("an image of the coat's normals, as `normalMap`, which does not turn them")
                            .row("Clear coat normal map", "A picture of the coat's normals.", ""),
                    map("sheenColorMap", Finish::sheen, Finish::withSheen, Sheen::colorMap, Sheen::withColorMap)
                            .means("an image that multiplies `sheenColor`")
                            .row("Sheen color map", "A picture that multiplies the sheen.", ""),
                    map(
                                    "sheenRoughnessMap",
                                    Finish::sheen,
                                    Finish::withSheen,
                                    Sheen::roughnessMap,
                                    Sheen::withRoughnessMap)
                            .means("an image whose red channel multiplies `sheenRoughness` (glTF's alpha channel)")
                            .row("Sheen roughness map", "A picture whose red channel multiplies it.", ""),
                    map(
                                    "anisotropyMap",
                                    Finish::anisotropy,
                                    Finish::withAnisotropy,
                                    Anisotropy::map,
                                    Anisotropy::withMap)
                            .means("an image: red and green are the direction, from -1 to 1, turned by"
                                    + " `anisotropyRotation`, blue multiplies `anisotropy`")
                            .row("Anisotropy map", "A picture: red and green the direction, blue the strength.", ""),
                    map("specularMap", Finish::specular, Finish::withSpecular, Specular::map, Specular::withMap)
                            .means("an image whose red channel multiplies `specular` (glTF's alpha channel)")
                            .row("Specular map", "A picture whose red channel multiplies the specular factor.", ""),
                    map(
                                    "specularColorMap",
                                    Finish::specular,
                                    Finish::withSpecular,
                                    Specular::colorMap,
                                    Specular::withColorMap)
                            .means("an image that multiplies `specularColor`")
                            .row("Specular color map", "A picture that multiplies the specular color.", ""),
                    map("iridescenceMap", Finish::film, Finish::withFilm, Film::map, Film::withMap)
                            .means("an image whose red channel multiplies `iridescence`")
                            .row("Iridescence map", "A picture whose red channel multiplies the film.", ""),
                    map(
                                    "iridescenceThicknessMap",
                                    Finish::film,
                                    Finish::withFilm,
                                    Film::thicknessMap,
                                    Film::withThicknessMap)
                            .means("an image whose green channel leads from `iridescenceThicknessMinimum` to"
                                    + " `iridescenceThickness`")
                            .row("Film thickness map", "A picture whose green channel is the film's thickness.", ""),
                    map("diffuseTransmissionMap", Finish::through, Finish::withThrough, Through::map, Through::withMap)
                            .means("an image whose red channel multiplies `diffuseTransmission` (glTF's alpha channel)")
                            .row("Diffuse transmission map", "A picture whose red channel multiplies it.", ""),
                    map(
                                    "diffuseTransmissionColorMap",
                                    Finish::through,
                                    Finish::withThrough,
                                    Through::colorMap,
                                    Through::withColorMap)
                            .means("an image that multiplies `diffuseTransmissionColor`")
                            .row("Diffuse transmission color map", "A picture that multiplies its color.", ""))
            .map(FinishProperties::ofMaterial)
            .toList();

    private FinishProperties() {}

    private static <P> Stream<Property<Finish, ?>> of(
            Function<Finish, P> part, BiFunction<Finish, P, Finish> withPart, List<Property<P, ?>> properties) {
        return Property.within(properties, part, withPart).stream();
    }

    private static <P> Property<Finish, Optional<Path>> map(
            String name,
            Function<Finish, P> part,
            BiFunction<Finish, P, Finish> withPart,
            Function<P, Optional<ImageMap>> getter,
            BiFunction<P, Optional<ImageMap>, P> wither) {
        return image(
                        name,
                        (P owner) -> getter.apply(owner).map(ImageMap::file),
                        (owner, file) -> wither.apply(owner, file.map(ImageMap::of)))
                .within(part, withPart);
    }

    private static <V> Property<Material, V> ofMaterial(Property<Finish, V> property) {
        return property.within(Material::finish, Material::withFinish).since(4).only(Integrator.PATH);
    }
}
