package dev.twister.world.table;

import dev.twister.sky.TextureImage;
import dev.twister.world.SceneImages;
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

    TextureImage image(SceneImages images) {
        return images.textureByFile().get(file);
    }
}
