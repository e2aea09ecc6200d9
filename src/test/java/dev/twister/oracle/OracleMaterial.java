package dev.twister.oracle;

import dev.twister.scene.Material;
import dev.twister.world.SceneImages;
import java.util.Optional;

/** What a body is made of. */
record OracleMaterial(
        Color color,
        double reflectivity,
        double roughness,
        double transmission,
        double ior,
        Optional<OracleTexture> texture) {
    /** The same with its texture, from the scene's images. */
    static OracleMaterial of(Material material, SceneImages images) {
        return new OracleMaterial(
                Color.of(material.color()),
                material.reflectivity(),
                material.roughness(),
                material.transmission(),
                material.ior(),
                material.texture()
                        .map(file -> new OracleTexture(images.textureByFile().get(file))));
    }

    boolean transmits() {
        return transmission > 0;
    }

    /** A color as it is at (u, v) of the texture, where there is one. */
    Color textured(Color base, double u, double v) {
        return texture.map(picture -> base.times(picture.color(u, v))).orElse(base);
    }
}
