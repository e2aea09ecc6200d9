package dev.twister.scene.format;

import static dev.twister.scene.format.Field.required;
import static dev.twister.scene.format.Field.sparse;

import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.format.ValueType.Choice;
import dev.twister.scene.format.ValueType.Converted;
import dev.twister.scene.format.ValueType.Decimal;
import dev.twister.scene.format.ValueType.FilePath;
import dev.twister.scene.format.ValueType.Flag;
import dev.twister.scene.format.ValueType.GroupName;
import dev.twister.scene.material.Alpha;
import dev.twister.scene.material.Attenuation;
import dev.twister.scene.material.Emission;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Maps;
import dev.twister.scene.property.SceneLimits;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The fields of a material, wherever one stands in a scene file.
 *
 * @param fields in the order in which they are written
 */
record MaterialFormat(List<Field<Material, ?>> fields) {
    private static final Field<Material, Rgb> COLOR =
            required("color", ValueType.color(SceneLimits.ALBEDO), Material::color, Material::withColor);

    private static final List<Field<Material, ?>> NUMBERS = List.of(
            required(
                    "reflectivity",
                    new Decimal(SceneLimits.REFLECTIVITY),
                    Material::reflectivity,
                    Material::withReflectivity),
            sparse("roughness", new Decimal(SceneLimits.ROUGHNESS), Material::roughness, Material::withRoughness)
                    .from(2),
            sparse("metallic", new Decimal(SceneLimits.METALLIC), Material::metallic, Material::withMetallic)
                    .from(3),
            sparse(
                            "transmission",
                            new Decimal(SceneLimits.TRANSMISSION),
                            Material::transmission,
                            Material::withTransmission)
                    .from(2),
            sparse("ior", new Decimal(SceneLimits.IOR), Material::ior, Material::withIor)
                    .from(2),
            emission("emission", ValueType.color(SceneLimits.RADIANCE), Emission::color, Emission::withColor),
            emission(
                    "emissionStrength",
                    new Decimal(SceneLimits.EMISSION_STRENGTH),
                    Emission::strength,
                    Emission::withStrength),
            emission("doubleSided", new Flag(), Emission::doubleSided, Emission::withDoubleSided),
            emission("lightGroup", new GroupName(), Emission::group, Emission::withGroup),
            sparse("attenuationColor", ValueType.color(SceneLimits.ALBEDO), Attenuation::color, Attenuation::withColor)
                    .within(Material::attenuation, Material::withAttenuation)
                    .from(3),
            Field.optional(
                            "attenuationDistance",
                            new Decimal(SceneLimits.LENGTH),
                            Attenuation::distance,
                            Attenuation::withDistance)
                    .within(Material::attenuation, Material::withAttenuation)
                    .from(3));

    private static <V> Field<Material, V> emission(
            String name, ValueType<V> type, Function<Emission, V> getter, BiFunction<Emission, V, Emission> wither) {
        return sparse(name, type, getter, wither)
                .within(Material::emission, Material::withEmission)
                .from(3);
    }

    static MaterialFormat whole(FilePath file) {
        return new MaterialFormat(Stream.concat(Stream.of(COLOR), uncolored(file).fields().stream())
                .toList());
    }

    /** Of bodies that have their colors from elsewhere. */
    static MaterialFormat uncolored(FilePath file) {
        return new MaterialFormat(Stream.concat(NUMBERS.stream(), images(file)).toList());
    }

    /** The same fields, any of which may be left out. */
    MaterialFormat optional() {
        return new MaterialFormat(
                fields.stream().<Field<Material, ?>>map(Field::orDefault).toList());
    }

    /** The same fields in an object that stands for something made of the material. */
    <R> List<Field<R, ?>> within(Function<R, Material> material, BiFunction<R, Material, R> withMaterial) {
        return fields.stream()
                .<Field<R, ?>>map(field -> field.within(material, withMaterial))
                .toList();
    }

    private static Stream<Field<Material, ?>> images(FilePath file) {
        ValueType<ImageMap> map = new Converted<>(file, ImageMap::of, ImageMap::file);
        return Stream.of(
                Field.optional("texture", file, Material::texture, Material::withTexture)
                        .from(2),
                map("emissionMap", map, Maps::emission, Maps::withEmission),
                map(
                        "roughnessMap",
                        map,
                        Maps::roughness,
                        (maps, value) -> maps.withRoughness(value).withMetallic(value)),
                map("normalMap", map, Maps::normal, Maps::withNormal),
                sparse("alphaMode", new Choice<>(Alpha.Mode.class), Alpha::mode, Alpha::withMode)
                        .within(Material::alpha, Material::withAlpha)
                        .from(3),
                sparse("alphaCutoff", new Decimal(SceneLimits.ALBEDO), Alpha::cutoff, Alpha::withCutoff)
                        .within(Material::alpha, Material::withAlpha)
                        .from(3));
    }

    private static Field<Material, ?> map(
            String name,
            ValueType<ImageMap> type,
            Function<Maps, Optional<ImageMap>> getter,
            BiFunction<Maps, ImageMap, Maps> wither) {
        return Field.optional(name, type, getter, wither)
                .within(Material::maps, Material::withMaps)
                .from(3);
    }
}
