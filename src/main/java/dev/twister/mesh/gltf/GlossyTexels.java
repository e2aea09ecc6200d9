package dev.twister.mesh.gltf;

import dev.twister.scene.Rgb;
import dev.twister.scene.SrgbCurve;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.Optional;

/**
 * Textures of diffuse colors, and of specular colors with glossiness, converted texel by texel.
 *
 * @param color base color and opacity, sRGB
 * @param metal roughness as green and metal as blue, linear
 */
record GlossyTexels(BufferedImage color, BufferedImage metal) {
    private static final int VALUES = 256;
    private static final double[] LINEAR = new double[VALUES];

    /** Linear values halfway between those of neighboring bytes. */
    private static final double[] BORDERS = new double[VALUES - 1];

    static {
        Arrays.setAll(LINEAR, value -> SrgbCurve.linear(value / 255.0));
        Arrays.setAll(BORDERS, value -> SrgbCurve.linear((value + 0.5) / 255.0));
    }

    /**
     * What the textures are multiplied by.
     *
     * @param diffuse linear
     * @param specular linear
     */
    record Factors(Rgb diffuse, double opacity, Rgb specular, double glossiness) {}

    /** The conversion, in the size of the larger image; a place has the nearest texel. */
    static GlossyTexels of(Optional<BufferedImage> diffuse, BufferedImage glossy, Factors factors) {
        int width =
                Math.max(glossy.getWidth(), diffuse.map(BufferedImage::getWidth).orElse(1));
        int height = Math.max(
                glossy.getHeight(), diffuse.map(BufferedImage::getHeight).orElse(1));
        BufferedImage color = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        BufferedImage metal = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int shown = diffuse.isPresent() ? texel(diffuse.get(), x, y, width, height) : -1;
                int shining = texel(glossy, x, y, width, height);
                MetalOfSpecular converted =
                        MetalOfSpecular.of(times(factors.diffuse(), shown), times(factors.specular(), shining));
                color.setRGB(
                        x,
                        y,
                        part(factors.opacity() * (shown >>> 24) / 255) << 24
                                | stored(converted.color().red()) << 16
                                | stored(converted.color().green()) << 8
                                | stored(converted.color().blue()));
                double roughness = 1 - factors.glossiness() * (shining >>> 24) / 255;
                metal.setRGB(x, y, part(roughness) << 8 | part(converted.metallic()));
            }
        }
        return new GlossyTexels(color, metal);
    }

    private static int texel(BufferedImage image, int x, int y, int width, int height) {
        return image.getRGB((int) ((long) x * image.getWidth() / width), (int) ((long) y * image.getHeight() / height));
    }

    private static Rgb times(Rgb factor, int texel) {
        return new Rgb(
                factor.red() * LINEAR[texel >> 16 & 0xff],
                factor.green() * LINEAR[texel >> 8 & 0xff],
                factor.blue() * LINEAR[texel & 0xff]);
    }

    private static int part(double value) {
        return (int) Math.round(255 * value);
    }

    private static int stored(double linear) {
        int found = Arrays.binarySearch(BORDERS, linear);
        return found < 0 ? -found - 1 : found;
    }
}
