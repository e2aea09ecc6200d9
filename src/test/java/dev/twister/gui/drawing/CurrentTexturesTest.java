package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.drawing.CurrentWorld.CurrentTextures;
import dev.twister.image.HdrWriter;
import dev.twister.image.PngWriter;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.sky.FloatImages;
import dev.twister.world.SceneMeshes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CurrentTexturesTest {
    @TempDir
    Path folder;

    private Path file;
    private Scene scene;
    private final ImageCache cache = new ImageCache();
    private final CurrentTextures textures = new CurrentTextures(cache, () -> Optional.of(scene));

    @BeforeEach
    void writeTheScene() throws IOException {
        Path sky = folder.resolve("sky.hdr");
        HdrWriter.write(sky, 2, 1, new float[6]);
        file = folder.resolve("texture.png");
        write(0);
        Sphere ball = Sphere.of(new Vector3(0, 0, 0), 1, new Rgb(1, 1, 1), 0)
                .withMaterial(Material.DEFAULT.withTexture(file));
        scene = Scene.under(sky).withSpheres(List.of(ball));
    }

    @Test
    void aTextureIsReadOnceUntilItsSceneIsReadAnew() throws IOException {
        assertThat(red()).isZero();
        write(0xffffff);
        assertThat(red()).isZero();
        assertThat(textures.areOld()).isFalse();

        cache.refresh(scene);

        assertThat(textures.areOld()).isTrue();
        assertThat(red()).isEqualTo(1);
    }

    @Test
    void aTextureThatCannotBeReadIsWhiteAndToldOfWhileTheSceneHasIt() throws IOException {
        Files.writeString(file, "no picture");

        assertThat(red()).isEqualTo(1);
        assertThat(red()).isEqualTo(1);
        assertThat(textures.complaint())
                .hasValueSatisfying(complaint -> assertThat(complaint).startsWith(file + ": not a texture"));
        textures.of(scene.withSpheres(List.of()), SceneMeshes.NONE);
        assertThat(textures.complaint()).isEmpty();
    }

    private float red() {
        return FloatImages.of(textures.of(scene, SceneMeshes.NONE).get(file)).radiance()[0];
    }

    private void write(int color) throws IOException {
        PngWriter.write(file, 1, 1, new int[] {color}, true);
    }
}
