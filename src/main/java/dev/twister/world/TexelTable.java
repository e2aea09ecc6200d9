package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.scene.Material;
import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The panorama and the used textures in one array, as the kernel reads them. */
final class TexelTable {
    private final SceneImages images;
    private final List<Path> textures = new ArrayList<>();

    TexelTable(SceneImages images) {
        this.images = images;
    }

    /**
     * The texture's number, from 1 on; 0 if the material has none.
     *
     * @throws IllegalArgumentException if the texture is not among the images
     */
    int number(Material material) {
        return material.texture().map(this::number).orElse(0);
    }

    private int number(Path texture) {
        if (!images.textureByFile().containsKey(texture)) {
            throw new IllegalArgumentException("the texture " + texture + " was not read");
        }
        if (!textures.contains(texture)) {
            textures.add(texture);
        }
        return 1 + textures.indexOf(texture);
    }

    /** @throws IllegalArgumentException if all texels together exceed the length of an array */
    Panorama panorama() {
        Skybox sky = images.sky();
        int[] dimensions = new int[Layout.SKY_DIMENSIONS_LENGTH + Layout.TEXTURE_STRIDE * textures.size()];
        dimensions[Layout.SKY_WIDTH] = sky.width();
        dimensions[Layout.SKY_HEIGHT] = sky.height();
        if (textures.isEmpty()) {
            return new Panorama(sky.radiance(), dimensions);
        }
        long length = sky.radiance().length;
        for (Path file : textures) {
            length += images.textureByFile().get(file).radiance().length;
        }
        if (length > Integer.MAX_VALUE - Long.BYTES) {
            throw new IllegalArgumentException("sky and textures have " + length / 3 + " texels together; at most "
                    + Integer.MAX_VALUE / 3 + " fit");
        }
        float[] texels = new float[(int) length];
        System.arraycopy(sky.radiance(), 0, texels, 0, sky.radiance().length);
        int start = sky.radiance().length;
        int at = Layout.SKY_DIMENSIONS_LENGTH;
        for (Path file : textures) {
            Skybox texture = images.textureByFile().get(file);
            System.arraycopy(texture.radiance(), 0, texels, start, texture.radiance().length);
            dimensions[at + Layout.TEXTURE_START] = start;
            dimensions[at + Layout.TEXTURE_WIDTH] = texture.width();
            dimensions[at + Layout.TEXTURE_HEIGHT] = texture.height();
            start += texture.radiance().length;
            at += Layout.TEXTURE_STRIDE;
        }
        return new Panorama(texels, dimensions);
    }
}
