package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.JvmEngines;
import dev.twister.engine.vector.VectorEngines;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Attenuation;
import dev.twister.scene.material.Emission;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Every ray loses light in the body that it is in: what a glowing ball behind some meters of it looks like. */
class MediaTest {
    private static final Skybox BLACK = new Skybox(1, 1, new float[3]);
    private static final Rgb DARK = new Rgb(0, 0, 0);
    private static final double METER = 0.5;

    /** As water without reflections: half of red, all of green and 0.8 of blue are left after a meter. */
    private static final Material WATER = Material.DEFAULT
            .withColor(new Rgb(1, 1, 1))
            .withReflectivity(0)
            .withTransmission(1)
            .withIor(1)
            .withAttenuation(new Attenuation(new Rgb(METER, 1, 0.8), Optional.of(1.0)));

    private static final Material CLEAR = WATER.withAttenuation(Attenuation.NONE);
    private static final Material LAMP = Material.DEFAULT
            .withColor(DARK)
            .withReflectivity(0)
            .withEmission(new Emission(new Rgb(1, 1, 1), 1, true, LightGroup.NONE));

    /** A lamp with its near side at z = 2, seen along z from the origin. */
    private static final Sphere BALL = Sphere.of(new Vector3(0, 0, 3), 1, LAMP);

    private static Scene scene(List<Sphere> spheres, List<Mesh> meshes) {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(Vector3.ZERO, 0, 0, 1))
                .withLights(Lights.of(Light.of(new Vector3(0, -900, 0), 1, DARK).withStrength(0.0)))
                .withGround(Ground.of(1, -500, DARK, DARK, 0))
                .withShading(new Shading(0))
                .withSpheres(spheres)
                .withMeshes(meshes)
                .withRendering(Rendering.DEFAULT
                        .withSize(16, 16)
                        .withShadowSamples(1)
                        .withBounces(6)
                        .withSrgb(false));
    }

    private static Sphere around(double z, double radius, Material material) {
        return Sphere.of(new Vector3(0, 0, z), radius, material);
    }

    private static Mesh box(double near, double far, Material material) {
        return Mesh.of(new Shape(Shape.Kind.BOX, new Vector3(8, 8, far - near)))
                .withPosition(new Vector3(0, 0, (near + far) / 2))
                .withMaterial(material);
    }

    static Stream<Arguments> scenes() {
        return Stream.of(
                        Arguments.of("camera in a sphere", scene(List.of(around(0, 9, WATER), BALL), List.of()), 2.0),
                        Arguments.of("sphere before it", scene(List.of(around(1, 0.5, WATER), BALL), List.of()), 1.0),
                        Arguments.of("camera in a box", scene(List.of(BALL), List.of(box(-4, 8, WATER))), 2.0),
                        Arguments.of("box before it", scene(List.of(BALL), List.of(box(0.5, 1.25, WATER))), 0.75),
                        Arguments.of(
                                "bubble in water",
                                scene(List.of(around(0, 9, WATER), around(1, 0.25, CLEAR), BALL), List.of()),
                                1.5),
                        Arguments.of(
                                "camera in a bubble in water",
                                scene(List.of(around(0, 9, WATER), around(0, 0.5, CLEAR), BALL), List.of()),
                                1.5),
                        Arguments.of(
                                "water in clear glass that it overlaps",
                                scene(List.of(around(1, 0.75, CLEAR), BALL), List.of(box(0.5, 1.5, WATER))),
                                1.0),
                        Arguments.of(
                                "ball in a box of water in a sphere of clear glass",
                                scene(List.of(around(3, 2.5, CLEAR), BALL), List.of(box(1, 6, WATER))),
                                1.0))
                .flatMap(arguments -> Stream.of(Integrator.values())
                        .flatMap(integrator -> Stream.of(JvmEngines.SEQUENTIAL, VectorEngines.VECTOR)
                                .map(engine -> Arguments.of(
                                        arguments.get()[0],
                                        arguments.get()[1],
                                        arguments.get()[2],
                                        integrator,
                                        engine))));
    }

    @ParameterizedTest(name = "{0}, {3}, {4}")
    @MethodSource("scenes")
    void ballIsTinted(String name, Scene scene, double meters, Integrator integrator, String engine) {
        Scene traced =
                scene.withRendering(scene.rendering().withIntegrator(integrator).withClamp(0));
        SceneMeshes meshes = SceneMeshes.read(traced, _ -> {});

        float[] radiance = Pictures.radiance(engine, new LitScene(traced, SceneImages.of(BLACK), meshes));

        int middle = 3 * (8 * 16 + 8);
        // Paths of four surfaces and more have gone on by chance, for which green stands.
        double green = radiance[middle + 1];
        assertThat(green).isBetween(1 - 2e-3, 1 / 0.95 + 2e-3);
        assertThat(radiance[middle] / green).isCloseTo(Math.pow(METER, meters), within(2e-3));
        assertThat(radiance[middle + 2] / green).isCloseTo(Math.pow(0.8, meters), within(2e-3));
    }
}
