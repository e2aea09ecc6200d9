package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.physics.Simulation;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Translating a whole scene, by even meters to keep the checks, must not change the picture. */
class MovedScenesTest {
    private static final double LARGEST_PLANE = 1e6;
    private static final int BLACK = 0xFF000000;

    @ParameterizedTest
    @CsvSource({
        "sequential, 400000, 900000, -300000",
        "sequential, -99998, -999000, 2",
        "vector, 400000, 900000, -300000",
        "vector, 2200, 6000, -5000"
    })
    void looksAsItDid(String engine, double x, double y, double z) {
        Scene scene = SceneReader.read(Path.of("scenes", "teaching.json"));
        Scene near = scene.withGround(scene.ground().withSize(LARGEST_PLANE))
                .withRendering(scene.rendering()
                        .withSize(320, 180)
                        .withShadowSamples(64)
                        .withBounces(1));
        Skybox sky = SkyboxReader.read(scene.sky().file());
        int[] moved = Pictures.argb(engine, moved(near, new Vector3(x, y, z)), sky);
        assertThat(PictureDifference.between(moved, Pictures.argb(JvmEngines.SEQUENTIAL, near, sky)))
                .matches(PictureDifference::isWithinBound, "is within the design's bound");
    }

    /** Straight above it, it divides the picture. */
    @ParameterizedTest
    @ValueSource(strings = {"sequential", "vector"})
    void planesBorderStaysWhereItIs(String engine) {
        Rgb white = new Rgb(1, 1, 1);
        double border = LARGEST_PLANE * (0.5 + 0x1p-17);
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(border, 4, -400_000), 0, 90, 90))
                .withGround(Ground.of(LARGEST_PLANE, 0, white, white, 0))
                .withShading(new Shading(1))
                .withRendering(Rendering.DEFAULT.withSize(40, 40).withShadowSamples(1));
        int[] argb = Pictures.argb(engine, scene, new Skybox(1, 1, new float[3]));
        assertThat(Arrays.stream(argb).filter(pixel -> pixel == BLACK)).hasSizeBetween(40 * 19, 40 * 21);
    }

    @ParameterizedTest
    @CsvSource({"400000, 900000, -300000", "0, 0, 0"})
    void motionStartsWhereTheSceneHasItsBodies(double x, double y, double z) {
        Scene scene = SceneReader.read(Path.of("scenes", "teaching.json"));
        Scene moved = moved(scene, new Vector3(x, y, z));
        World world = World.of(moved, new Skybox(1, 1, new float[3]));
        float[] places = world.snapshot().bodies().floats();
        try (Simulation simulation = Simulation.of(moved)) {
            simulation.place(world);
        }
        assertThat(world.snapshot().bodies().floats()).containsExactly(places);
    }

    private static Scene moved(Scene scene, Vector3 by) {
        return scene.withCamera(scene.camera().withPosition(sum(scene.camera().position(), by)))
                .withLights(Lights.of(scene.lights()
                        .first()
                        .withPosition(sum(scene.lights().first().position(), by))))
                .withGround(scene.ground().withHeight(scene.ground().height() + by.y()))
                .withSpheres(scene.spheres().stream()
                        .map(sphere -> sphere.withPosition(sum(sphere.position(), by)))
                        .toList());
    }

    private static Vector3 sum(Vector3 a, Vector3 b) {
        return new Vector3(a.x() + b.x(), a.y() + b.y(), a.z() + b.z());
    }
}
