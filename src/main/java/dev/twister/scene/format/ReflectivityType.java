package dev.twister.scene.format;

import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.format.json.JsonText;
import dev.twister.scene.material.Reflectance;
import dev.twister.scene.property.MaterialProperties;
import java.util.LinkedHashMap;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;

/**
 * The reflectivity of a material: until version 3 a metallic part only tints what it mirrors, and 0 is as if it were
 * not given.
 *
 * @param version of the format
 */
record ReflectivityType(int version) implements ValueType<Material> {
    /** The version in which a metal is a metal at every reflectivity. */
    static final int METALS_SINCE = 4;

    private static final Set<String> TINTING = Set.of("metallic", "reflectivity");

    /** The field, for a version of the format. */
    static Field<Material, Material> field(int version) {
        Field<Material, Material> field = Field.sparse(
                MaterialProperties.REFLECTIVITY.name(),
                new ReflectivityType(version),
                ReflectivityType::part,
                (material, read) ->
                        material.withReflectivity(read.reflectivity()).withReflectance(read.reflectance()));
        Field<Material, Material> meant = field.meaning(MaterialProperties.REFLECTIVITY.meaning());
        return version < METALS_SINCE ? meant.inEachWritten() : meant;
    }

    /** The metallic part until version 3, which only tints. */
    static Field<Material, Double> tint(Field<Material, Double> metallic) {
        return metallic.with((material, metal) -> {
            Material changed = metallic.with().apply(material, metal);
            return metal > 0 && changed.reflectivity() > 0 ? changed.withReflectance(Reflectance.TINTED) : changed;
        });
    }

    /** The scene of an older file, in which a track makes a metal or a mirror of what is not one at first. */
    static Scene tintedByTracks(Scene scene) {
        Set<Material> tinted = scene.tracks().stream()
                .filter(track -> TINTING.contains(track.property()))
                .flatMap(track -> material(scene, track.target()).stream())
                .collect(Collectors.toSet());
        if (tinted.isEmpty()) {
            return scene;
        }
        UnaryOperator<Material> tint =
                material -> tinted.contains(material) ? material.withReflectance(Reflectance.TINTED) : material;
        SequencedMap<String, Material> materials = new LinkedHashMap<>(scene.materials());
        materials.replaceAll((_, material) -> tint.apply(material));
        return scene.withMaterials(materials)
                .withGround(
                        scene.ground().withMaterial(tint.apply(scene.ground().material())))
                .withSpheres(scene.spheres().stream()
                        .map(sphere -> sphere.withMaterial(tint.apply(sphere.material())))
                        .toList())
                .withMeshes(scene.meshes().stream()
                        .map(mesh -> mesh.withMaterial(mesh.material().map(tint)))
                        .toList());
    }

    private static Optional<Material> material(Scene scene, TrackTarget target) {
        int index = target.index();
        return switch (target.kind()) {
            case PLANE -> Optional.of(scene.ground().material());
            case SPHERE ->
                scene.spheres().stream().skip(index).map(Sphere::material).findFirst();
            case MESH -> scene.meshes().stream().skip(index).findFirst().flatMap(Mesh::material);
            case CAMERA, LIGHT, SKY, SHADING, RENDERING -> Optional.empty();
        };
    }

    /** What of a material the field says, and what decides which version it needs. */
    private static Material part(Material material) {
        // What is no number is refused when it is read.
        return material.reflectivity() != 0 || material.reflectance() == Reflectance.CONSTANT
                ? Material.DEFAULT
                        .withReflectivity(material.reflectivity())
                        .withReflectance(material.reflectance())
                        .withMetallic(material.metallic())
                : Material.DEFAULT;
    }

    @Override
    public Material read(Place place) {
        double reflectivity = place.number(MaterialProperties.REFLECTIVITY.range());
        boolean given = version >= METALS_SINCE && reflectivity == 0;
        return Material.DEFAULT
                .withReflectivity(reflectivity)
                .withReflectance(given ? Reflectance.CONSTANT : Reflectance.MIXED);
    }

    @Override
    public String write(Material value) {
        return JsonText.number(value.reflectivity());
    }

    @Override
    public int version(Material value) {
        boolean mixes = value.reflectance() == Reflectance.CONSTANT
                || (value.reflectance() == Reflectance.MIXED && value.reflectivity() > 0 && value.metallic() > 0);
        return mixes ? METALS_SINCE : 1;
    }
}
