package dev.twister.scene.property;

import static dev.twister.scene.property.Property.choice;
import static dev.twister.scene.property.Property.color;
import static dev.twister.scene.property.Property.decimal;
import static dev.twister.scene.property.Property.flag;
import static dev.twister.scene.property.Property.image;
import static dev.twister.scene.property.Slide.SHARE;
import static dev.twister.scene.property.Slide.linear;
import static dev.twister.scene.property.Slide.logarithmic;

import dev.twister.scene.Integrator;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.Alpha;
import dev.twister.scene.material.Attenuation;
import dev.twister.scene.material.Emission;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Maps;
import dev.twister.scene.property.PropertyType.Decimal;
import dev.twister.scene.property.PropertyType.Given;
import dev.twister.scene.property.PropertyType.LayerName;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Stream;

/** The properties of a material, in the order in which a scene file has them. */
public final class MaterialProperties {
    public static final Property<Material, Rgb> COLOR = color(
                    "color", SceneLimits.SHARE, Material::color, Material::withColor)
            .written()
            .animated()
            .means("albedo: red, green, blue")
            .row("Color", "The color of the surface.", "Alt+9");

    public static final Property<Material, Double> REFLECTIVITY = decimal(
                    "reflectivity", new Range(0, 128), Material::reflectivity, Material::withReflectivity)
            .written()
            .animated()
            .means("Blinn-Phong exponent; divided by 128, the share of mirrored light")
            .row(
                    "Reflectivity",
                    "Share of the light that is mirrored. The number p beside it is the exponent of the highlight, "
                            + "from 0 (matte) to 128 (mirror).",
                    "Alt+8");

    public static final Property<Material, Double> ROUGHNESS = decimal(
                    "roughness", SceneLimits.SHARE, Material::roughness, Material::withRoughness)
            .since(2)
            .animated()
            .means("roughness of reflections and refractions; 0 is smooth")
            .row(
                    "Roughness",
                    "How much reflections and refractions are blurred: 0 is smooth, 1 is rough. The picture at rest "
                            + "gathers samples until the noise is gone.",
                    "Alt+Shift+R")
            .slide(SHARE);

    public static final Property<Material, Double> METALLIC = decimal(
                    "metallic", SceneLimits.SHARE, Material::metallic, Material::withMetallic)
            .since(3)
            .animated()
            .means("how much of a metal it is: reflections take its color")
            .row("Metallic", "How much of a metal it is: reflections take its color.", "")
            .slide(SHARE);

    public static final Property<Material, Double> TRANSMISSION = decimal(
                    "transmission", SceneLimits.SHARE, Material::transmission, Material::withTransmission)
            .since(2)
            .animated()
            .means("share of the light that is not mirrored and passes the surface")
            .row(
                    "Transmission",
                    "Share of the light that is not mirrored and passes through the surface: 0 is opaque, 1 is clear.",
                    "Alt+Shift+T")
            .slide(SHARE);

    public static final Property<Material, Double> IOR = decimal(
                    "ior", new Range(1, 4), Material::ior, Material::withIor)
            .since(2)
            .animated()
            .means("index of refraction, relative to what surrounds the body")
            .row(
                    "Index of refraction",
                    "How much transmitted light is bent: water 1.33, glass 1.5, diamond 2.42.",
                    "Alt+Shift+I")
            .slide(linear(1, 2.5, 2, ""));

    private static final Property<Material, Double> SPECULAR = decimal(
                    "specular", SceneLimits.SHARE, Material::specular, Material::withSpecular)
            .since(4)
            .animated()
            .means("in path tracing, without `reflectivity`: factor of what `ior` reflects; not of metals")
            .row(
                    "Specular",
                    "In path tracing, without reflectivity: factor of what the index of refraction reflects.",
                    "")
            .slide(SHARE)
            .only(Integrator.PATH);

    private static final Property<Material, Boolean> THIN_WALLED = flag(
                    "thinWalled", Material::thinWalled, Material::withThinWalled)
            .since(4)
            .means("whether the surface is a thin sheet: what passes goes straight on, and nothing is inside")
            .row(
                    "Thin-walled",
                    "The surface is a thin sheet: what passes goes straight on, and nothing is inside.",
                    "");

    public static final Property<Material, Rgb> EMISSION = color(
                    "emission", SceneLimits.RADIANCE, Emission::color, Emission::withColor)
            .within(Material::emission, Material::withEmission)
            .since(3)
            .animated()
            .means("color of the light that it emits; spheres emit outward")
            .row("Emission", "The color of the light that it emits; black emits nothing.", "");

    public static final Property<Material, Double> EMISSION_STRENGTH = decimal(
                    "emissionStrength", SceneLimits.RADIANCE, Emission::strength, Emission::withStrength)
            .within(Material::emission, Material::withEmission)
            .since(3)
            .animated()
            .means("factor of the emission")
            .row("Emission strength", "Factor of the emission.", "")
            .slide(logarithmic(0.1, 1000, 2, ""));

    public static final Property<Material, String> LIGHT_GROUP = Property.of(
                    "lightGroup", new LayerName(), Emission::group, Emission::withGroup)
            .within(Material::emission, Material::withEmission)
            .since(3)
            .means("name of the [layer](denoising.md#light-by-light) of its emitted light")
            .row("Emission layer", "Name of the layer of its emitted light, for --light-layers.", "");

    private static final List<Property<Material, ?>> NUMBERS = List.of(
            REFLECTIVITY,
            ROUGHNESS,
            METALLIC,
            TRANSMISSION,
            IOR,
            SPECULAR,
            THIN_WALLED,
            EMISSION,
            EMISSION_STRENGTH,
            flag("doubleSided", Emission::doubleSided, Emission::withDoubleSided)
                    .within(Material::emission, Material::withEmission)
                    .since(3)
                    .means("whether triangles emit on both sides, otherwise on the outer one")
                    .row("Double-sided", "Whether triangles emit on both sides, otherwise on the outer one.", ""),
            LIGHT_GROUP,
            color("attenuationColor", SceneLimits.SHARE, Attenuation::color, Attenuation::withColor)
                    .within(Material::attenuation, Material::withAttenuation)
                    .since(3)
                    .means("what is left of white light after the distance, inside a transmitting body")
                    .row("Attenuation", "What is left of white light after the distance, inside the body.", ""),
            Property.<Attenuation, Optional<Double>>of(
                            "attenuationDistance",
                            new Given<>(new Decimal(SceneLimits.LENGTH)),
                            Attenuation::distance,
                            Attenuation::withDistance)
                    .within(Material::attenuation, Material::withAttenuation)
                    .since(3)
                    .means("that distance; without it nothing is lost")
                    .row("Attenuation distance", "That distance; at 1,000,000 m nothing is lost.", "")
                    .slide(logarithmic(0.01, 100, 2, "m")));

    public static final Property<Material, Optional<Path>> TEXTURE = image(
                    "texture", Material::texture, Material::withTexture)
            .since(2)
            .means("an image that multiplies the color")
            .row("Texture", "A picture that multiplies the color.", "Alt+Shift+X");

    private static final List<Property<Material, Optional<Path>>> BASE_IMAGES = List.of(
            TEXTURE,
            map("emissionMap", Maps::emission, Maps::withEmission)
                    .means("an image that multiplies the emission")
                    .row("Emission map", "A picture that multiplies the emission.", ""),
            map(
                            "roughnessMap",
                            Maps::roughness,
                            (maps, map) -> maps.withRoughness(map).withMetallic(map))
                    .means("an image whose green channel multiplies the roughness and whose blue one multiplies"
                            + " `metallic`")
                    .row("Roughness map", "A picture: green multiplies the roughness, blue the metallic part.", ""),
            map("normalMap", Maps::normal, Maps::withNormal)
                    .means("an image of normals, as in glTF; a gray one holds heights, of which 1 is one texel")
                    .row("Normal map", "A picture of normals, as glTF has them; a gray one holds heights.", ""));

    /** In the order in which their files are read. */
    public static final List<Property<Material, Optional<Path>>> IMAGES = Stream.concat(
                    BASE_IMAGES.stream(), FinishProperties.IMAGES.stream())
            .toList();

    private static final List<Property<Material, ?>> ALPHA = List.of(
            choice("alphaMode", Alpha.Mode.class, Alpha::mode, Alpha::withMode)
                    .within(Material::alpha, Material::withAlpha)
                    .since(3)
                    .means("what the texture's alpha channel does on a mesh: nothing, cut out, let light pass")
                    .row("Opacity", "What the texture's alpha channel does: nothing, cut out, or let light pass.", ""),
            decimal("alphaCutoff", SceneLimits.SHARE, Alpha::cutoff, Alpha::withCutoff)
                    .within(Material::alpha, Material::withAlpha)
                    .since(3)
                    .means("with `mask`, what is less opaque is cut out")
                    .row("Opacity cutoff", "With Mask: what is less opaque is cut out.", "")
                    .slide(SHARE));

    public static final List<Property<Material, ?>> ALL =
            List.of(List.<Property<Material, ?>>of(COLOR), NUMBERS, FinishProperties.NUMBERS, IMAGES, ALPHA).stream()
                    .<Property<Material, ?>>flatMap(List::stream)
                    .toList();

    private static final List<String> EMITTED =
            List.of("emission", "emissionStrength", "doubleSided", "lightGroup", "emissionMap");

    private MaterialProperties() {}

    /** Whether only meshes have it. */
    public static boolean isOfMeshes(Property<?, ?> property) {
        return ALPHA.stream().anyMatch(alpha -> alpha.name().equals(property.name()));
    }

    /** Whether it is of the light that a body emits, which the plane cannot. */
    public static boolean isOfEmission(Property<?, ?> property) {
        return EMITTED.contains(property.name());
    }

    private static Property<Material, Optional<Path>> map(
            String name, Function<Maps, Optional<ImageMap>> getter, BiFunction<Maps, Optional<ImageMap>, Maps> wither) {
        return image(
                        name,
                        (Maps maps) -> getter.apply(maps).map(ImageMap::file),
                        (maps, file) -> wither.apply(maps, file.map(ImageMap::of)))
                .within(Material::maps, Material::withMaps)
                .since(3);
    }
}
