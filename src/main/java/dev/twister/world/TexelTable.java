package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.scene.Material;
import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
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

    /** The files of the textures in the order of their numbers. */
    List<Path> textures() {
        return List.copyOf(textures);
    }

    /**
     * The array {@code images} of {@link Layout}.
     *
     * @throws IllegalArgumentException if all texels together exceed the length of an array
     */
    float[] images() {
        float[] sky = images.sky().radiance();
        if (textures.isEmpty()) {
            return sky;
        }
        long length = sky.length;
        for (Path file : textures) {
            length = aligned(length) + radiance(file).length;
        }
        if (length > Integer.MAX_VALUE - Long.BYTES) {
            throw new IllegalArgumentException("sky and textures have " + length / Layout.TEXEL_STRIDE
                    + " texels together; at most " + Integer.MAX_VALUE / Layout.TEXEL_STRIDE + " fit");
        }
        float[] texels = Arrays.copyOf(sky, (int) length);
        int end = sky.length;
        for (Path file : textures) {
            int start = (int) aligned(end);
            System.arraycopy(radiance(file), 0, texels, start, radiance(file).length);
            end = start + radiance(file).length;
        }
        return texels;
    }

    /** The array {@code looks} of {@link Layout}: the bodies' looks, then the table of the textures. */
    float[] withTable(float[] looks) {
        float[] extended = Arrays.copyOf(looks, looks.length + Layout.TEXTURE_STRIDE * textures.size());
        long end = images.sky().radiance().length;
        int at = looks.length;
        for (Path file : textures) {
            Skybox texture = images.textureByFile().get(file);
            extended[at + Layout.TEXTURE_START] = (int) (aligned(end) / Layout.ALIGNMENT);
            extended[at + Layout.TEXTURE_WIDTH] = texture.width();
            extended[at + Layout.TEXTURE_HEIGHT] = texture.height();
            end = aligned(end) + texture.radiance().length;
            at += Layout.TEXTURE_STRIDE;
        }
        return extended;
    }

    private float[] radiance(Path texture) {
        return images.textureByFile().get(texture).radiance();
    }

    private static long aligned(long length) {
        return (length + Layout.ALIGNMENT - 1) / Layout.ALIGNMENT * Layout.ALIGNMENT;
    }
}
