package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.twister.image.HdrWriter;
import dev.twister.image.PngWriter;
import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.oracle.MeshShapes;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.material.Finish;
import dev.twister.scene.material.ImageMap;
import dev.twister.sky.FloatImages;
import dev.twister.sky.PngBytes;
import dev.twister.sky.SkyException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneImagesTest {
    private static final Sphere BALL = Sphere.of(new Vector3(0, 0, 0), 1, new Rgb(1, 1, 1), 0);

    @TempDir
    Path folder;

    private Path sky;
    private final List<String> warnings = new ArrayList<>();

    @BeforeEach
    void writeTheSky() throws IOException {
        sky = folder.resolve("sky.hdr");
        HdrWriter.write(sky, 2, 1, new float[6]);
    }

    @Test
    void readsEachTextureOnceAndMakesItLinear() throws IOException {
        byte[] gray = PngBytes.start(1, 8, PngBytes.GRAY)
                .damagedChunk("gAMA", new byte[4])
                .texels(188);
        Path file = Files.write(folder.resolve("gray.png"), gray);
        Path other = folder.resolve("other.png");
        PngWriter.write(other, 2, 1, new int[] {0xff0000, 0x00ff00}, true);
        Scene scene = Scene.under(sky)
                .withGround(plane(file))
                .withSpheres(List.of(BALL, BALL.withMaterial(textured(file)), BALL.withMaterial(textured(other))));

        SceneImages images = SceneImages.read(scene, warnings::add);

        assertThat(images.sky().width()).isEqualTo(2);
        assertThat(images.textureByFile()).containsOnlyKeys(file, other);
        assertThat(FloatImages.of(images.textureByFile().get(file)).radiance()[0])
                .isCloseTo(0.503f, within(0.001f));
        assertThat(FloatImages.of(images.textureByFile().get(other)).radiance()).containsExactly(1, 0, 0, 0, 1, 0);
        assertThat(warnings).containsExactly(file + ": the gAMA chunk is damaged and is ignored");
    }

    @Test
    void saysWhereATextureThatCannotBeReadIsNamed() throws IOException {
        Path file = Files.writeString(folder.resolve("words.png"), "no picture");
        Scene scene = Scene.under(sky).withSpheres(List.of(BALL, BALL.withMaterial(textured(file))));

        assertThatThrownBy(() -> SceneImages.read(scene, warnings::add))
                .isInstanceOf(SkyException.class)
                .hasMessage("$.spheres[1].texture: " + file
                        + ": not a texture by its first bytes; PNG, JPEG and WebP are read");
        assertThatThrownBy(() -> SceneImages.read(scene.withGround(plane(folder.resolve("none.png"))), warnings::add))
                .isInstanceOf(SkyException.class)
                .hasMessage("$.plane.texture: " + folder.resolve("none.png") + ": file not found");
    }

    @Test
    void tellsOfATextureThatAMeshDoesNotShow() throws IOException {
        Path file = folder.resolve("red.png");
        PngWriter.write(file, 1, 1, new int[] {0xff0000}, true);
        Mesh mesh = Mesh.of(folder.resolve("box.obj")).withMaterial(textured(file));
        Scene scene = Scene.under(sky).withMeshes(List.of(mesh));

        SceneImages.read(scene, SceneMeshes.of(scene, _ -> MeshShapes.file(MeshShapes.cube())), warnings::add);

        assertThat(warnings)
                .containsExactly(mesh.geometry() + ": no texture coordinates; the texture red.png is not shown");
    }

    @Test
    void aDamagedTextureOfAMeshFileIsWhite() throws IOException {
        Path damaged =
                Files.write(folder.resolve("damaged.png"), new byte[] {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10});
        MeshFile cube = MeshShapes.file(MeshShapes.cube());
        MeshFile box = new MeshFile(
                cube.meshes(), List.of(new MeshPart("", 0, Affine.IDENTITY, textured(damaged))), Map.of(), 0);
        Scene scene = Scene.under(sky).withMeshes(List.of(Mesh.of(folder.resolve("box.obj"))));

        SceneImages images = SceneImages.read(scene, SceneMeshes.of(scene, _ -> box), warnings::add);

        assertThat(images.textureByFile()).containsEntry(damaged, SceneImages.WHITE);
        assertThat(warnings).anyMatch(warning -> warning.contains(damaged + ": "));
    }

    @Test
    void refusesRadianceAsATexture() {
        Scene scene = Scene.under(sky).withGround(plane(sky));

        assertThatThrownBy(() -> SceneImages.read(scene, warnings::add))
                .isInstanceOf(SkyException.class)
                .hasMessage(
                        "$.plane.texture: " + sky + ": a Radiance picture, but a texture must be PNG, JPEG or WebP");
    }

    @Test
    void namesWhatPathTracingAloneShows() {
        Finish coated = Finish.NONE.withClearcoat(Finish.NONE.clearcoat().withPart(1));
        Finish both = coated.withDispersion(0.3);
        Scene scene = Scene.under(sky)
                .withSpheres(List.of(
                        BALL.withMaterial(Material.DEFAULT.withFinish(coated)),
                        BALL.withMaterial(Material.DEFAULT.withFinish(both)),
                        BALL.withMaterial(Material.DEFAULT
                                .withReflectivity(9)
                                .withFinish(
                                        Finish.NONE.withFilm(Finish.NONE.film().withPart(1))))));

        SceneImages.read(scene, SceneMeshes.NONE, warnings::add);
        SceneImages.read(
                scene.withRendering(scene.rendering().withIntegrator(Integrator.PATH)),
                SceneMeshes.NONE,
                warnings::add);

        assertThat(warnings)
                .containsExactly("not shown without path tracing: clearcoat, dispersion; try --integrator path");
    }

    @Test
    void namesTheFieldOfAMapThatIsMissing() {
        Finish coated = Finish.NONE.withClearcoat(
                Finish.NONE.clearcoat().withMap(Optional.of(ImageMap.of(folder.resolve("none.png")))));
        Scene scene = Scene.under(sky).withSpheres(List.of(BALL.withMaterial(Material.DEFAULT.withFinish(coated))));

        assertThatThrownBy(() -> SceneImages.read(scene, warnings::add))
                .hasMessageStartingWith("$.spheres[0].clearcoatMap: ");
    }

    private static Ground plane(Path texture) {
        return Ground.of(1, 0, new Rgb(1, 1, 1), new Rgb(1, 1, 1), 0).withMaterial(textured(texture));
    }

    private static Material textured(Path file) {
        return Material.DEFAULT.withTexture(file);
    }
}
