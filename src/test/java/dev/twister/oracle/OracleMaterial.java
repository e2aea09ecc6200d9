package dev.twister.oracle;

import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.Attenuation;
import dev.twister.sky.FloatImages;
import dev.twister.world.SceneImages;
import java.util.Optional;

/** Material properties of a body. */
record OracleMaterial(
        Color color,
        double reflectivity,
        double roughness,
        double transmission,
        double ior,
        boolean thin,
        Optional<OracleTexture> texture,
        double metallic,
        boolean byFresnel,
        boolean besideMetal,
        double besideReflectivity,
        Color emission,
        boolean emitsInward,
        Color absorption) {
    /** Attaches the texture from the scene's images. */
    static OracleMaterial of(Material material, SceneImages images) {
        return new OracleMaterial(
                Color.of(material.color()),
                material.whittedReflectivity(),
                material.roughness(),
                material.transmission(),
                material.ior(),
                material.thinWalled(),
                material.texture()
                        .map(file -> new OracleTexture(
                                FloatImages.of(images.textureByFile().get(file)),
                                material.maps().texture())),
                material.metallic(),
                material.isByFresnel(),
                material.isMetalOverMirror(),
                material.reflectivity(),
                Color.of(material.emission().radiance()),
                material.emission().doubleSided(),
                absorption(material.attenuation()));
    }

    private static Color absorption(Attenuation attenuation) {
        Rgb color = attenuation.color();
        return attenuation
                .distance()
                .map(distance -> new Color(-Math.log(color.red()), -Math.log(color.green()), -Math.log(color.blue()))
                        .times(1 / distance))
                .orElse(Color.BLACK);
    }

    /** What multiplies reflections. */
    Color tint(Color albedo) {
        return albedo.times(metallic).plus(new Color(1 - metallic, 1 - metallic, 1 - metallic));
    }

    /** What is left of white light after a distance inside. */
    Color passed(double distance) {
        return new Color(
                Math.exp(-absorption.red() * distance),
                Math.exp(-absorption.green() * distance),
                Math.exp(-absorption.blue() * distance));
    }

    OracleMaterial withEmission(Color newEmission) {
        return new OracleMaterial(
                color,
                reflectivity,
                roughness,
                transmission,
                ior,
                thin,
                texture,
                metallic,
                byFresnel,
                besideMetal,
                besideReflectivity,
                newEmission,
                emitsInward,
                absorption);
    }

    boolean emits() {
        return emission.strongest() > 0;
    }

    boolean transmits() {
        return transmission > 0;
    }

    /** As {@link #textured}, where the texture ends at v = 0 and v = 1. */
    Color texturedToPoles(Color base, double u, double v) {
        return texture.map(picture -> base.times(picture.color(u, picture.between(v))))
                .orElse(base);
    }

    /** Modulates a color by the texture at (u, v), if there is one. */
    Color textured(Color base, double u, double v) {
        return texture.map(picture -> base.times(picture.color(u, v))).orElse(base);
    }
}
