package dev.twister.mesh.gltf;

import dev.twister.scene.Rgb;

/**
 * The metal that looks like a surface with a diffuse and a specular color, converted as the example of the authors of
 * KHR_materials_pbrSpecularGlossiness converts it.
 *
 * @param color linear base color
 * @param metallic in [0, 1]
 */
record MetalOfSpecular(Rgb color, double metallic) {
    /** Reflectance of plastic at normal incidence. */
    private static final double DIELECTRIC = 0.04;

    private static final double SMALL = 1e-6;

    /** Of two linear colors. */
    static MetalOfSpecular of(Rgb diffuse, Rgb specular) {
        double left = 1 - Math.max(specular.red(), Math.max(specular.green(), specular.blue()));
        double metallic = metallic(luminance(diffuse), luminance(specular), left);
        if (metallic == 0) {
            return new MetalOfSpecular(new Rgb(unit(diffuse.red()), unit(diffuse.green()), unit(diffuse.blue())), 0);
        }
        return new MetalOfSpecular(
                new Rgb(
                        mixed(diffuse.red(), specular.red(), left, metallic),
                        mixed(diffuse.green(), specular.green(), left, metallic),
                        mixed(diffuse.blue(), specular.blue(), left, metallic)),
                metallic);
    }

    private static double mixed(double diffuse, double specular, double left, double metallic) {
        double ofDiffuse = diffuse * left / (1 - DIELECTRIC) / Math.max(1 - metallic, SMALL);
        double ofSpecular = (specular - DIELECTRIC * (1 - metallic)) / Math.max(metallic, SMALL);
        return unit(ofDiffuse + metallic * metallic * (ofSpecular - ofDiffuse));
    }

    private static double unit(double value) {
        return Math.clamp(value, 0.0, 1.0);
    }

    private static double luminance(Rgb color) {
        return Math.sqrt(0.299 * color.red() * color.red()
                + 0.587 * color.green() * color.green()
                + 0.114 * color.blue() * color.blue());
    }

    /** The part of metal that makes both brightnesses: a root of a quadratic equation. */
    private static double metallic(double diffuse, double specular, double left) {
        if (specular < DIELECTRIC) {
            return 0;
        }
        double b = diffuse * left / (1 - DIELECTRIC) + specular - 2 * DIELECTRIC;
        double c = DIELECTRIC - specular;
        double root = Math.sqrt(Math.max(b * b - 4 * DIELECTRIC * c, 0));
        return unit((root - b) / (2 * DIELECTRIC));
    }
}
