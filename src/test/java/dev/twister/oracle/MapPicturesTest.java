package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Alpha;
import dev.twister.scene.material.Emission;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Maps;
import dev.twister.scene.material.Sampler;
import dev.twister.scene.material.Wrap;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares meshes with maps, vertex colors and opacity with the oracle. */
class MapPicturesTest {
    private static final int WIDTH = 80;
    private static final int HEIGHT = 60;
    private static final Path FILE = Path.of("shape.obj");
    private static final Path IMAGE = Path.of("image.png");
    private static final Path TEXTURE = Path.of("texture.png");
    private static final Skybox SKY =
            new Skybox(2, 2, new float[] {0.2f, 0.4f, 0.9f, 0.9f, 0.5f, 0.2f, 0.3f, 0.3f, 0.3f, 0.1f, 0.2f, 0.1f});
    private static final ImageMap MAP = ImageMap.of(IMAGE);
    private static final Material MATTE = Material.DEFAULT.withColor(new Rgb(0.8, 0.7, 0.6));
    private static final Material GLTF = MATTE.withMetallic(0.9).withRoughness(0.7);
    private static final Material TEXTURED = MATTE.withTexture(TEXTURE);

    private static Material mapped(Material material, Maps maps) {
        return material.withMaps(maps);
    }

    private static Arguments of(String name, Material material) {
        return Arguments.of(name, material);
    }

    static Stream<Arguments> materials() {
        Maps none = Maps.NONE;
        return Stream.of(
                of("vertex colors", MATTE),
                of("clamped", mapped(TEXTURED, none.withTexture(new Sampler(Wrap.CLAMP, Wrap.MIRROR, false, 0)))),
                of("nearest", mapped(TEXTURED, none.withTexture(new Sampler(Wrap.MIRROR, Wrap.REPEAT, true, 0)))),
                of(
                        "emission",
                        mapped(MATTE.withEmission(Emission.NONE.withColor(new Rgb(1, 2, 3))), none.withEmission(MAP))),
                of("metal and roughness", mapped(GLTF, none.withRoughness(MAP).withMetallic(MAP))),
                of("normals", mapped(MATTE.withReflectivity(30), none.withNormal(MAP))),
                of("scaled normals", mapped(MATTE, none.withNormal(MAP.withScale(0.4)))),
                of("occlusion", mapped(MATTE, none.withOcclusion(MAP.withScale(0.7)))),
                of("mask", TEXTURED.withAlpha(new Alpha(Alpha.Mode.MASK, 1, 0.5))),
                of("blended", TEXTURED.withAlpha(new Alpha(Alpha.Mode.BLEND, 0.9, 0.5))),
                of("ignored opacity", TEXTURED),
                of("unlit", TEXTURED.withUnlit(true)));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("materials")
    void picturesAreTheOracles(String name, Material material) {
        PixelJudge judge = new PixelJudge();
        LitScene scene = scene(material);
        judge.judge(Pictures.argb(JvmEngines.SEQUENTIAL, scene), scene);
        judge.requireExcusedAtMostOneIn(150);
    }

    /** Lanes decline what they do not know. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("materials")
    void lanesShowTheSame(String name, Material material) {
        LitScene scene = scene(material);
        assertThat(PictureDifference.between(
                        Pictures.argb(JvmEngines.SEQUENTIAL, scene), Pictures.argb("vector", scene)))
                .matches(PictureDifference::isWithinBound);
    }

    private static LitScene scene(Material material) {
        Random random = new Random(7);
        TriangleMesh ball = colored(MeshShapes.icosphere(1), random);
        TriangleMesh sheet = colored(MeshShapes.square(), random);
        MeshFile file = MeshShapes.file(
                List.of(ball, sheet),
                List.of(
                        new MeshPart("ball", 0, Affine.IDENTITY, material),
                        new MeshPart(
                                "sheet",
                                1,
                                new Affine(
                                        new Vector3(1, 0, 0.2),
                                        new Vector3(0, 0.3, 1),
                                        new Vector3(0, 1, -0.3),
                                        new Vector3(2.1, 0.2, -0.6)),
                                material)));
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0.8, 1.2, -5), 3, 8, 46))
                .withLights(Lights.of(Light.of(new Vector3(-3, 5, -4), 0.5, new Rgb(1, 1, 1))))
                .withGround(Ground.of(20, -1, new Rgb(0.7, 0.7, 0.7), new Rgb(0.3, 0.3, 0.3), 10))
                .withRendering(Rendering.DEFAULT
                        .withSize(WIDTH, HEIGHT)
                        .withShadowSamples(6)
                        .withBounces(4))
                .withMeshes(List.of(Mesh.of(FILE)));
        SceneImages images = new SceneImages(SKY, Map.of(IMAGE, image(random, false), TEXTURE, image(random, true)));
        return new LitScene(scene, images, SceneMeshes.of(scene, _ -> file));
    }

    /** Of soft contrast, so that rounding decides little; one texel is far from gray. */
    private static Skybox image(Random random, boolean holes) {
        int size = 4;
        float[] texels = new float[3 * size * size];
        float[] opacity = new float[size * size];
        for (int i = 0; i < texels.length; i++) {
            texels[i] = (i % 3 == 2 ? 0.5f : 0.1f) + 0.3f * random.nextFloat();
            opacity[i / 3] = random.nextFloat();
        }
        return holes ? new Skybox(size, size, texels, opacity) : new Skybox(size, size, texels);
    }

    private static TriangleMesh colored(TriangleMesh mesh, Random random) {
        float[] colors = new float[4 * mesh.vertices()];
        for (int i = 0; i < colors.length; i++) {
            colors[i] = 0.6f + 0.4f * random.nextFloat();
        }
        return new TriangleMesh(
                mesh.positions(), mesh.normals(), mesh.textureCoordinates(), colors, new float[0], mesh.corners());
    }
}
