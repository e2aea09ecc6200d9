package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.material.Alpha;
import dev.twister.scene.material.Attenuation;
import dev.twister.scene.material.Emission;
import dev.twister.scene.material.Finish;
import dev.twister.scene.material.Maps;
import dev.twister.scene.material.Reflectance;
import dev.twister.scene.property.Copied;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;

/**
 * What a body is made of; the names are glTF 2.0's where it has one.
 *
 * @param color albedo
 * @param reflectivity p in [0, 128]: the Blinn-Phong exponent; p / 128 is the mirror ratio
 * @param reflectance what reflectivity and metallic are to each other
 * @param roughness r in [0, 1] of the surface that reflects and refracts: 0 is smooth
 * @param metallic M in [0, 1]: how much of a metal it is, whose reflections have its color; the rest is what the
 *     material is otherwise
 * @param transmission t in [0, 1]: how much of the light that is not mirrored passes the surface
 * @param ior index of refraction against what is around the body, in [1, 4]
 * @param specular factor of what it reflects by its index of refraction, in [0, 1], in path tracing
 * @param thinWalled whether its surface is a thin sheet: what passes goes straight on, and nothing is inside
 * @param texture a picture that the color is multiplied by, already resolved against the scene file's folder
 * @param emission light that it emits
 * @param attenuation what light loses inside
 * @param alpha its opacity, of a mesh alone
 * @param maps images that vary its properties
 * @param finish what path tracing alone shows of it
 * @param unlit whether it shows its color as it is, without light
 */
@Copied
public record Material(
        Rgb color,
        double reflectivity,
        Reflectance reflectance,
        double roughness,
        double metallic,
        double transmission,
        double ior,
        double specular,
        boolean thinWalled,
        Optional<Path> texture,
        Emission emission,
        Attenuation attenuation,
        Alpha alpha,
        Maps maps,
        Finish finish,
        boolean unlit)
        implements MaterialCopy.With {
    /** Of a smooth metal, without path tracing. */
    private static final double METAL_REFLECTIVITY = 96;

    /** Matte and white, with the index of glass; has the values of the fields that a file leaves out. */
    public static final Material DEFAULT = new Material(
            new Rgb(1, 1, 1),
            0,
            Reflectance.MIXED,
            0,
            0,
            0,
            1.5,
            1,
            false,
            Optional.empty(),
            Emission.NONE,
            Attenuation.NONE,
            Alpha.OPAQUE,
            Maps.NONE,
            Finish.NONE,
            false);

    public Material {
        requireNonNull(color, "color");
        requireNonNull(reflectance, "reflectance");
        requireNonNull(texture, "texture");
        requireNonNull(emission, "emission");
        requireNonNull(attenuation, "attenuation");
        requireNonNull(alpha, "alpha");
        requireNonNull(maps, "maps");
        requireNonNull(finish, "finish");
        if (reflectance == Reflectance.CONSTANT && reflectivity > 0) {
            reflectance = Reflectance.MIXED;
        }
    }

    public Material withTexture(Path newTexture) {
        return withTexture(Optional.of(newTexture));
    }

    public Material withoutTexture() {
        return withTexture(Optional.empty());
    }

    /** The files of its texture and all its maps. */
    public Set<Path> images() {
        Set<Path> files = new LinkedHashSet<>();
        texture.ifPresent(files::add);
        maps.all().forEach(map -> files.add(map.file()));
        finish.maps().forEach(map -> files.add(map.file()));
        return files;
    }

    /** Without texture and maps, as on a mesh without texture coordinates. */
    public Material withoutImages() {
        return withoutTexture().withMaps(Maps.NONE).withFinish(finish.withoutMaps());
    }

    /** Whether, in path tracing, Fresnel's equations decide what it reflects: glTF's material, without reflectivity. */
    public boolean isByFresnel() {
        return reflectivity == 0
                && reflectance != Reflectance.CONSTANT
                && (metallic > 0 || roughness > 0 || !finish.isNone());
    }

    /** Whether path tracing shows a finish, which only a material has whose reflections Fresnel's equations decide. */
    public boolean hasFinish() {
        return isByFresnel() && !unlit && !finish.isNone();
    }

    /** Whether, in path tracing, a metal is mixed with a constant reflection. */
    public boolean isMetalOverMirror() {
        return !isByFresnel() && reflectance != Reflectance.TINTED && metallic > 0;
    }

    /**
     * The reflectivity without path tracing, where a glTF material and a metal shine the more the smoother they are;
     * glass reflects by its index of refraction.
     */
    public double whittedReflectivity() {
        if (isMetalOverMirror()) {
            return Math.max(reflectivity, METAL_REFLECTIVITY * metallic * (1 - roughness));
        }
        boolean derived = isByFresnel() && (metallic > 0 || transmission == 0);
        return derived ? (5 + 91 * metallic) * (1 - roughness) : reflectivity;
    }
}
