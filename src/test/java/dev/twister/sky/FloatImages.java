package dev.twister.sky;

/** Textures as floats. */
public final class FloatImages {
    private FloatImages() {}

    public static Skybox of(TextureImage image) {
        return switch (image) {
            case Skybox floats -> floats;
            case PackedImage packed -> unpacked(packed);
        };
    }

    private static Skybox unpacked(PackedImage image) {
        float[] radiance = new float[3 * image.texels().length];
        float[] opacity = new float[image.texels().length];
        for (int texel = 0; texel < opacity.length; texel++) {
            for (int channel = 0; channel < 3; channel++) {
                radiance[3 * texel + channel] = image.linear()[image.value(texel, channel)];
            }
            opacity[texel] = image.value(texel, 3) / 255f;
        }
        return image.isOpaque()
                ? new Skybox(image.width(), image.height(), radiance)
                : new Skybox(image.width(), image.height(), radiance, opacity);
    }
}
