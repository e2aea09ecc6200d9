package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.mesh.MeshException;
import dev.twister.scene.Camera;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.Triangles;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TwisterTest {
    private static final Rendering SMALL = Rendering.DEFAULT.withSize(32, 18).withShadowSamples(4);

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
    void changedSceneOfFileIsRefusedByTheValue() {
        Scene scene = SceneReader.read(Path.of("scenes", "mirrors.json")).withRendering(SMALL.withWidth(-1));
        assertThatThrownBy(() -> Twister.render(scene))
                .isInstanceOf(SceneException.class)
                .hasMessageContaining("width is -1");
    }

    @Test
    void missingSceneIsNamed() {
        Scene scene = null;
        assertThatThrownBy(() -> Twister.render(scene))
                .isInstanceOf(NullPointerException.class)
                .hasMessage("scene");
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

    @Test
    void trianglesOfCodeLookLikeTheShape() {
        float[] corners = {-1, 2, 0, 1, 2, 0, 1, 0, 0, -1, 0, 0};
        Mesh made = Mesh.of(Triangles.of("wall", corners, new int[] {0, 1, 2, 0, 2, 3}));
        Mesh quad = Mesh.of(new Shape(Shape.Kind.QUAD, new Vector3(2, 2, 0))).withPosition(new Vector3(0, 1, 0));
        assertThat(Twister.render(level().mesh(made)).frame().argb())
                .isEqualTo(Twister.render(level().mesh(quad)).frame().argb());
    }

    @Test
    void trianglesOfCodeMoveWithTheirMesh() {
        Mesh made = Mesh.of(Triangles.of("wall", new float[] {-1, 0, 0, 0, 2, 0, 1, 0, 0}, new int[] {0, 1, 2}));
        World world = level().mesh(made).world();
        int[] here = Twister.render(world, "parallel").frame().argb();
        world.setMesh(0, made.withPosition(new Vector3(50, 0, 0)));
        assertThat(Twister.render(world, "parallel").frame().argb())
                .isNotEqualTo(here)
                .isEqualTo(Twister.render(level()).frame().argb());
    }

    @Test
    void trianglesOfCodeAreChecked() {
        float[] corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        assertRefused(() -> Triangles.of("t", corners, new int[] {0, 1, 3}), "corners[2] is 3, but must be a number");
        assertRefused(() -> Triangles.of("t", corners, new int[] {0, 1}), "corners has 2 numbers, but");
        assertRefused(
                () -> Triangles.of("t", new float[] {0, Float.NaN, 0}, new int[] {0, 0, 0}),
                "positions[1] is NaN, but");
        Mesh flat = Mesh.of(Triangles.of("flat", corners, new int[] {0, 1, 1}));
        assertThatThrownBy(level().mesh(flat)::world)
                .isInstanceOf(MeshException.class)
                .hasMessageEndingWith("flat: holds no triangle with an area");
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
                .hasMessageStartingWith("scene: $.spheres[0].radius is -1, but must be");
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1, Double.NaN, Double.POSITIVE_INFINITY, 1e30})
    void skyColorsAreRefused(double red) {
        SceneBuilder scene = new SceneBuilder();
        assertThatThrownBy(() -> scene.sky(new Rgb(red, 0, 0)))
                .isInstanceOf(SceneException.class)
                .hasMessageStartingWith("sky.red is ");
    }

    @Test
    void settingsOfAWorldAreRefused() {
        World world = level().world();
        assertRefused(() -> world.setSettings(SMALL.withSize(-3, 4)), "rendering.width is -3, but must be a number");
        assertRefused(() -> world.setSettings(SMALL.withShadowSamples(0)), "rendering.shadowSamples is 0, but");
        assertRefused(() -> world.setSettings(SMALL.withBounces(-1)), "rendering.bounces is -1, but");
        assertRefused(() -> world.setSettings(SMALL.withExposure(Double.NaN)), "rendering.exposure is NaN, but");
        assertThat(world.settings()).isEqualTo(SMALL);
    }

    @Test
    void camerasOfAWorldAreRefused() {
        World world = level().world();
        Camera camera = world.camera();
        assertRefused(() -> world.setCamera(camera.withFieldOfViewDegrees(500)), "camera.fieldOfView is 500, but");
        Vector3 nowhere = new Vector3(0, Double.NaN, 0);
        assertRefused(() -> world.setCamera(camera.withPosition(nowhere)), "camera.position.y is NaN, but");
        assertThat(world.camera()).isEqualTo(camera);
    }

    private static void assertRefused(ThrowingCallable change, String start) {
        assertThatThrownBy(change).isInstanceOf(SceneException.class).hasMessageStartingWith(start);
    }

    @Test
    void nullsAreNamed() {
        World world = level().world();
        assertThatThrownBy(() -> world.setCamera(null))
                .isInstanceOf(NullPointerException.class)
                .hasMessage("camera");
        assertThatThrownBy(() -> new SceneBuilder().sphere(null))
                .isInstanceOf(NullPointerException.class)
                .hasMessage("sphere");
        assertThatThrownBy(() -> Sphere.DEFAULT.withMaterial(null))
                .isInstanceOf(NullPointerException.class)
                .hasMessage("material");
    }

    @ParameterizedTest
    @ValueSource(strings = {"sequential", "parallel", "auto"})
    void closedEngineRefusesToRender(String id) {
        Engine engine = Engines.open(id);
        engine.close();
        FrameInput input = level().world().snapshot();
        assertThatThrownBy(() -> engine.render(input, Frame.ofPixels(32, 18)))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("engine " + engine.id() + " is closed");
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
