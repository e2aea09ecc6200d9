package dev.twister.sky;

/** An image that varies a surface: linear floats, or what 8 bits per channel stand for. */
public sealed interface TextureImage permits Skybox, PackedImage {
    int width();

    int height();

    /** Whether all texels are. */
    boolean isOpaque();
}
