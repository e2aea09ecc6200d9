package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.engine.vector.VectorEngines;
import dev.twister.kernel.Variant;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Spheres with equal centers and radii, some of glass, have one picture, which the oracle draws too. */
class SpheresInOnePlaceTest {
    private static final Skybox SKY = new Skybox(1, 1, new float[] {0.2f, 0.4f, 0.9f});
    private static final Vector3 PLACE = new Vector3(0, 1, 0);
    private static final Material GLASS = Material.DEFAULT.withTransmission(1).withReflectivity(4);
    private static final Material RED = Material.DEFAULT.withColor(new Rgb(1, 0.3, 0.2));
    private static final Material MIRROR = RED.withReflectivity(100);

    private static Scene scene(Material... materials) {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0, 1.2, -5), 0, 5, 45))
                .withLights(Lights.of(Light.of(new Vector3(-4, 6, -3), 0.5, new Rgb(1, 1, 1))))
                .withGround(Ground.of(20, 0, new Rgb(0.9, 0.9, 0.9), new Rgb(0.3, 0.3, 0.3), 0))
                .withSpheres(Arrays.stream(materials)
                        .map(material -> Sphere.of(PLACE, 1, material))
                        .toList())
                .withRendering(
                        Rendering.DEFAULT.withSize(96, 72).withShadowSamples(12).withBounces(5));
    }

    private static Scene crowded(Scene scene) {
        Stream<Sphere> far = Stream.iterate(0, i -> i + 1)
                .limit(40)
                .map(i -> Sphere.of(new Vector3(i - 20, 0.2, 8 + i % 3), 0.2, i % 2 == 0 ? RED : GLASS));
        return scene.withSpheres(Stream.concat(scene.spheres().stream(), far).toList());
    }

    static Stream<Scene> scenes() {
        return Stream.of(
                scene(GLASS, RED),
                scene(RED, GLASS),
                scene(MIRROR, GLASS),
                scene(GLASS, MIRROR),
                scene(GLASS, GLASS),
                scene(GLASS, GLASS, RED),
                crowded(scene(GLASS, RED)),
                crowded(scene(GLASS, GLASS)));
    }

    private static int variant(Scene scene) {
        return new LitScene(scene, SKY).world().snapshot().variant(false);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void allDrawOnePicture(Scene scene) {
        PixelJudge judge = new PixelJudge();
        int[] picture = Pictures.argb(JvmEngines.SEQUENTIAL, scene, SKY);

        judge.judge(picture, scene, SKY);
        judge.requireExcusedAtMostOneIn(300);
        assertThat(Pictures.argb(JvmEngines.PARALLEL, scene, SKY)).isEqualTo(picture);
        assertThat(Pictures.argb(VectorEngines.VECTOR, scene, SKY)).isEqualTo(picture);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void allTraceOnePicture(Scene scene) {
        Scene traced = scene.withRendering(
                scene.rendering().withIntegrator(Integrator.PATH).withSamplesPerPixel(2));
        int[] picture = Pictures.argb(JvmEngines.SEQUENTIAL, traced, SKY);

        assertThat(Pictures.argb(JvmEngines.PARALLEL, traced, SKY)).isEqualTo(picture);
        assertThat(PictureDifference.between(Pictures.argb(VectorEngines.VECTOR, traced, SKY), picture))
                .matches(PictureDifference::isWithinBound);
    }

    @Test
    void theFirstHidesTheOthersUnlessItTransmits() {
        assertThat(Pictures.argb(JvmEngines.SEQUENTIAL, scene(RED, GLASS), SKY))
                .isEqualTo(Pictures.argb(JvmEngines.SEQUENTIAL, scene(RED), SKY));
    }

    @Test
    void theKernelIsToldWhereOneTransmits() {
        List<Sphere> apart = List.of(Sphere.of(PLACE, 1, GLASS), Sphere.of(PLACE, 1.5, RED));

        assertThat(variant(scene(GLASS, RED)) & Variant.TWINS).isNotZero();
        assertThat(variant(crowded(scene(RED, GLASS))) & Variant.TWINS).isNotZero();
        assertThat(variant(scene(RED, MIRROR)) & Variant.TWINS).isZero();
        assertThat(variant(crowded(scene(GLASS))) & Variant.TWINS).isZero();
        assertThat(variant(scene().withSpheres(apart)) & Variant.TWINS).isZero();
    }
}
