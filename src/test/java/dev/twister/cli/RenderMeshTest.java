package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.image.HdrWriter;
import dev.twister.image.Provenance;
import dev.twister.mesh.gltf.AnimatedGltf;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RenderMeshTest {
    private static final String TRIANGLE = "v -1 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n";

    @TempDir
    private Path folder;

    @Test
    void aMeshIsShownAsInView() throws IOException {
        Path mesh = Files.writeString(folder.resolve("a.obj"), TRIANGLE);
        Path scene = folder.resolve("a.json");
        assertThat(Outcome.of("view", mesh.toString(), "-o", scene.toString()).exitCode())
                .isZero();

        byte[] direct = bytes(render(mesh.toString(), "a.png"));
        byte[] viewed = bytes(render(scene.toString(), "b.png", "--samples", "4", "--shadow-samples", "8"));

        assertThat(direct).isEqualTo(viewed);
    }

    @Test
    void withoutABackgroundItIsCutOut() throws IOException {
        Path mesh = Files.writeString(folder.resolve("a.obj"), TRIANGLE);
        BufferedImage picture = ImageIO.read(
                render(mesh.toString(), "a.png", "--background", "none").toFile());

        assertThat(alpha(picture, 0, 0)).isZero();
        assertThat(alpha(picture, 31, 17)).isZero();
        assertThat(alpha(picture, 16, 9)).isEqualTo(255);
        List<Integer> edges = new ArrayList<>();
        for (int x = 0; x < picture.getWidth(); x++) {
            edges.add(alpha(picture, x, 9));
        }
        // Four samples per pixel.
        assertThat(edges).containsAnyOf(64, 128, 191);
    }

    /** The color of a pixel that a body covers in part is the body's alone. */
    @Test
    void theSkyIsNotInTheColorsOfEdges() throws IOException {
        Path mesh = Files.writeString(folder.resolve("a.obj"), "mtllib a.mtl\nusemtl black\n" + TRIANGLE);
        Files.writeString(folder.resolve("a.mtl"), "newmtl black\nKd 0 0 0\nKs 0 0 0\n");
        BufferedImage picture = ImageIO.read(
                render(mesh.toString(), "a.png", "--background", "none").toFile());

        for (int pixel = 0; pixel < 32 * 18; pixel++) {
            assertThat(picture.getRGB(pixel % 32, pixel / 32) & 0xFFFFFF).isZero();
        }
    }

    /** A camera that goes away from a mesh at rest. */
    @Test
    void aMovingCameraCarriesItsView() throws IOException {
        AnimatedGltf gltf = new AnimatedGltf();
        int times = gltf.accessor("SCALAR", 0, 1);
        int places = gltf.accessor("VEC3", 0, 0, 2, 0, 0, 12);
        String text = gltf.nodes(",{\"camera\":0}")
                .channel(1, "translation", "LINEAR", times, places)
                .text(",\"cameras\":[{\"perspective\":{\"yfov\":1}}]");
        String mesh = Files.writeString(folder.resolve("a.gltf"), text).toString();
        String[] end = {"--camera-view", "camera", "--time", "1"};
        byte[] near = bytes(render(mesh, "near.png", "--camera-view", "camera"));

        assertThat(bytes(render(mesh, "start.png", "--camera-view", "camera", "--time", "0")))
                .isEqualTo(near);
        assertThat(bytes(render(mesh, "end.png", end))).isNotEqualTo(near);
        assertThat(bytes(render(mesh, "fixed.png", "--camera-view", "camera", "--yaw", "0", "--time", "1")))
                .isEqualTo(bytes(render(mesh, "fixed-start.png", "--camera-view", "camera", "--yaw", "0")));
    }

    @Test
    void theSkyIsNotInTheAutomaticExposure() throws IOException {
        HdrWriter.write(
                folder.resolve("white.hdr"), 2, 1, new float[] {1, 1, 1, 1, 1, 1}, new Provenance("", "picture", "1"));
        Path scene = Files.writeString(folder.resolve("ball.json"), """
                {"version": 3, "camera": {"position": [0, 0, -10], "yaw": 0, "pitch": 0, "fieldOfView": 30},
                 "light": {"position": [0, 1000, 0], "radius": 1, "color": [0, 0, 0]}, "skybox": "white.hdr",
                 "plane": {"size": 1, "height": -5000, "colors": [[0, 0, 0], [0, 0, 0]], "reflectivity": 0},
                 "shading": {"ambient": 1}, "rendering": {"srgb": true},
                 "spheres": [{"position": [0, 0, 0], "radius": 2, "color": [0.05, 0.05, 0.05], "reflectivity": 0}]}
                """);
        BufferedImage picture = ImageIO.read(
                render(scene.toString(), "a.png", "--background", "none", "--exposure", "auto", "--samples", "1")
                        .toFile());

        // Middle gray.
        assertThat(picture.getRGB(16, 9)).isEqualTo(0xFF767676);
    }

    @Test
    void aFolderBecomesOnePictureEachAndGoesOnAfterFailures() throws IOException {
        Files.writeString(folder.resolve("a.obj"), TRIANGLE);
        Files.writeString(folder.resolve("b.obj"), "v 0 0 zero\n");
        Files.writeString(folder.resolve("c.obj"), TRIANGLE);
        Path pictures = folder.resolve("new/pictures");

        Outcome outcome = Outcome.of("render", folder.toString(), "-o", pictures.toString(), "--size", "8x8");

        assertThat(outcome.exitCode()).isEqualTo(2);
        assertThat(pictures.toFile().list()).containsExactlyInAnyOrder("a.png", "c.png");
        assertThat(outcome.err()).startsWith("twister: " + folder.resolve("b.obj") + ":1: ");
        assertThat(outcome.out().lines().toList().reversed().subList(0, 4).reversed())
                .first()
                .isEqualTo("Pictures in " + pictures + ": 2, failed: 1");
        assertThat(outcome.out()).contains("  a.obj -> a.png", "  b.obj -> failed: ", "  c.obj -> c.png");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            benchmark | a.png | --up z | --up, --rotate, --scene and --animation are for mesh files
            benchmark | a.hdr | --background none | --background none needs a .png, .exr or .apng file
            benchmark | a.mp4 | --background none --turntable 1 | --background none needs an .apng file
            benchmark | a.png | --background none --view normal | --background none needs the full picture
            benchmark | a.png | --background none --stage colors | --background none needs the full picture
            benchmark | a.png | --background blue | unknown value 'blue'; expected one of: sky, none
            . | a.png | --up z | --output is
            a.obj | a.png | --rotate 1,2 | --rotate has 2 angles
            """)
    void refuses(String scene, String picture, String options, String message) throws IOException {
        Files.writeString(folder.resolve("a.obj"), TRIANGLE);
        Path file = folder.resolve(scene);
        List<String> arguments = new ArrayList<>(List.of(
                "render",
                Files.exists(file) ? file.toString() : scene,
                "-o",
                folder.resolve(picture).toString()));
        arguments.addAll(List.of(options.split(" ")));

        Outcome outcome = Outcome.of(arguments.toArray(String[]::new));

        assertThat(outcome.err()).contains(message);
        assertThat(outcome.exitCode()).isEqualTo(2);
    }

    private Path render(String scene, String name, String... options) {
        Path file = folder.resolve(name);
        List<String> arguments = new ArrayList<>(
                List.of("render", scene, "-o", file.toString(), "--size", "32x18", "--engine", "sequential"));
        arguments.addAll(List.of(options));
        Outcome outcome = Outcome.of(arguments.toArray(String[]::new));
        assertThat(outcome.err()).isEmpty();
        return file;
    }

    private static byte[] bytes(Path file) throws IOException {
        BufferedImage picture = ImageIO.read(file.toFile());
        byte[] bytes = new byte[3 * picture.getWidth() * picture.getHeight()];
        for (int pixel = 0; pixel < bytes.length / 3; pixel++) {
            int rgb = picture.getRGB(pixel % picture.getWidth(), pixel / picture.getWidth());
            bytes[3 * pixel] = (byte) (rgb >> 16);
            bytes[3 * pixel + 1] = (byte) (rgb >> 8);
            bytes[3 * pixel + 2] = (byte) rgb;
        }
        return bytes;
    }

    private static int alpha(BufferedImage picture, int x, int y) {
        return picture.getRGB(x, y) >>> 24;
    }
}
