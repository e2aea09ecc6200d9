package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.sky.Skybox;
import java.nio.file.Path;

/** A file of an image, and what is taken from it. */
record MapUse(Path file, Content content) {
    /** What a texel holds. */
    enum Content {
        /** Linear color. */
        COLOR,
        /** The stored numbers. */
        NUMBERS,
        /** Normals in tangent space; heights become normals. */
        NORMALS,
        /** The alpha channel, one number. */
        ALPHA,
        /** The first channel's stored number. */
        RED
    }

    Skybox image(SceneImages images) {
        return images.textureByFile().get(file);
    }

    /** Number of floats. */
    long length(SceneImages images) {
        Skybox image = image(images);
        boolean single = content == Content.ALPHA || content == Content.RED;
        return (single ? 1L : Layout.TEXEL_STRIDE) * image.width() * image.height();
    }
}
