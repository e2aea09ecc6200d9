package dev.twister.oracle;

import dev.twister.scene.Material;
import dev.twister.world.SceneImages;
import java.util.Optional;

/** Material properties of a body. */
record OracleMaterial(
        Color color,
        double reflectivity,
        double roughness,
        double transmission,
        double ior,
        Optional<OracleTexture> texture) {
    /** Attaches the texture from the scene's images. */
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

    /** Modulates a color by the texture at (u, v), if there is one. */
    Color textured(Color base, double u, double v) {
        return texture.map(picture -> base.times(picture.color(u, v))).orElse(base);
    }
}
