package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.scene.Camera;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TwisterTest {
    private static final Rendering SMALL = Rendering.DEFAULT.withSize(32, 18).withShadows(4);

    @TempDir
    private Path folder;

    @Test
    void sceneFileIsRendered() {
        Scene scene = SceneReader.read(Path.of("scenes", "mirrors.json")).withRendering(SMALL);
        assertThat(Twister.render(scene).frame().argb())
                .hasSize(32 * 18)
                .isEqualTo(Twister.render(scene, "sequential").frame().argb());
    }

    @Test
    void sceneInCodeNeedsNoSkyFile() {
        RenderedPicture picture = Twister.render(new SceneBuilder()
                .camera(Camera.of(new Vector3(0, 2, 0), 0, -60, 40))
                .sky(new Rgb(1, 0, 0.5))
                .rendering(SMALL.withSrgb(false)));
        assertThat(picture.frame().argb()).containsOnly(0xffff0080);
    }

    @Test
    void spheresAreSeen() {
        SceneBuilder scene = level();
        int without = middle(scene);
        assertThat(middle(scene.sphere(Sphere.of(new Vector3(0, 1, 0), 1, new Rgb(1, 0, 0), 0))))
                .isNotEqualTo(without);
    }

    @Test
    void meshesAreSeen() {
        SceneBuilder scene = level();
        int without = middle(scene);
        Mesh vase = Mesh.of(Path.of("scenes", "meshes", "vase.ply")).withScale(3);
        assertThat(middle(scene.mesh(vase))).isNotEqualTo(without);
    }

    private static SceneBuilder level() {
        return new SceneBuilder()
                .camera(Camera.of(new Vector3(0, 1, -5), 0, 0, 40))
                .rendering(SMALL);
    }

    private static int middle(SceneBuilder scene) {
        return Twister.render(scene).toImage().getRGB(16, 9);
    }

    @Test
    void valueOutOfRangeIsNamed() {
        SceneBuilder scene = new SceneBuilder().sphere(Sphere.of(new Vector3(0, 0, 0), -1, new Rgb(1, 1, 1), 0));
        assertThatThrownBy(scene::world)
                .isInstanceOf(SceneException.class)
                .hasMessageContaining("spheres[0].radius is -1");
    }

    @Test
    void pngAndImageHaveThePixels() throws IOException {
        RenderedPicture picture = Twister.render(new SceneBuilder().rendering(SMALL));
        Path file = folder.resolve("picture.png");
        picture.writePng(file);
        assertThat(pixels(ImageIO.read(file.toFile())))
                .isEqualTo(picture.frame().argb());
        assertThat(pixels(picture.toImage())).isEqualTo(picture.frame().argb());
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }
}
