package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import dev.twister.image.Frame;
import dev.twister.oracle.PictureDifference;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.FieldSource;

/** Values from the ends of the ranges that scenes allow: lanes render what the kernel renders, and never NaN. */
final class ExtremesTest {
    private static final Rgb BLACK = new Rgb(0, 0, 0);
    private static final Rgb WHITE = new Rgb(1, 1, 1);
    private static final Vector3 ORIGIN = new Vector3(0, 0, 0);

    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void lightAtTheCamera(int bits) {
        assertSame(
                bits,
                Scene.under(Path.of("none.hdr"))
                        .withCamera(Camera.of(ORIGIN, 0, 0, 10))
                        .withLights(Lights.of(Light.of(ORIGIN, 1, BLACK)))
                        .withGround(Ground.of(1, 0, BLACK, BLACK, 0))
                        .withShading(new Shading(0))
                        .withRendering(settings(67, 19)));
    }

    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void cameraWhereThreeSpheresTouch(int bits) {
        assertSame(
                bits,
                Scene.under(Path.of("none.hdr"))
                        .withCamera(Camera.of(ORIGIN, 0, 0, 1))
                        .withLights(Lights.of(Light.of(new Vector3(1, 0, 0), 1, BLACK)))
                        .withGround(Ground.of(1, 0, BLACK, BLACK, 0))
                        .withSpheres(List.of(
                                Sphere.of(new Vector3(1e6, 0, 0), 1e6, BLACK, 0),
                                Sphere.of(new Vector3(-1e6, 0, 0), 1e6, new Rgb(0, 0, 1), 0)))
                        .withShading(new Shading(0))
                        .withRendering(settings(97, 1)));
    }

    /** The squares of such heights underflow to 0. */
    @ParameterizedTest
    @CsvSource({"128, 1e-30, 5", "256, 1e-30, 5", "512, 1e-30, 5", "512, 1e-12, 1e-12", "512, 5, 1e-30"})
    void eyeOrLightNextToThePlane(int bits, double eye, double light) {
        assertSame(
                bits,
                Scene.under(Path.of("none.hdr"))
                        .withCamera(Camera.of(new Vector3(0, eye, 0), 0, 60, 60))
                        .withLights(Lights.of(Light.of(new Vector3(0, light, -10), 1, WHITE)))
                        .withGround(Ground.of(40, 0, WHITE, WHITE, 8))
                        .withShading(new Shading(0))
                        .withRendering(settings(67, 59)));
    }

    /** From far above, each pixel hits another check: the last bits of the hit point decide which. */
    @ParameterizedTest
    @CsvSource({"128, 20000", "256, 20000", "512, 20000", "512, 800", "512, -20000"})
    void checksFarSmallerThanPixels(int bits, double lightHeight) {
        assertSame(
                bits,
                Scene.under(Path.of("none.hdr"))
                        .withCamera(Camera.of(new Vector3(-300, 9000, 200), 12, 35, 20))
                        .withLights(Lights.of(Light.of(new Vector3(50, lightHeight, 30), 1, WHITE)))
                        .withGround(Ground.of(1e6, 0, WHITE, BLACK, 64))
                        .withRendering(settings(320, 200).withBounces(1)));
    }

    /**
     * Terminated lanes beside lanes with mirrors continue with stale values that are squared at each bounce, up to
     * infinity.
     */
    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void glassBehindFarMirrors(int bits) {
        assertSame(
                bits,
                Scene.under(Path.of("none.hdr"))
                        .withCamera(Camera.of(new Vector3(0, 0, -3e5), 0, 0, 10))
                        .withLights(Lights.of(Light.of(new Vector3(0, 5e5, -3e5), 1, WHITE)))
                        .withGround(Ground.of(1, -9e5, BLACK, BLACK, 0))
                        .withSpheres(List.of(
                                Sphere.of(new Vector3(-1.01e5, 0, 0), 1e5, WHITE, 128),
                                Sphere.of(new Vector3(1.01e5, 0, 0), 1e5, WHITE, 128),
                                Sphere.of(new Vector3(0, 0, -6e5), 1, WHITE, 0)
                                        .withMaterial(Material.DEFAULT.withTransmission(1))))
                        .withShading(new Shading(1))
                        .withRendering(settings(64, 16).withBounces(8)));
    }

    private static Rendering settings(int width, int height) {
        return Rendering.DEFAULT
                .withSize(width, height)
                .withShadowSamples(16)
                .withBounces(0)
                .withSamplesPerPixel(1);
    }

    private static void assertSame(int bits, Scene scene) {
        FrameInput input = World.of(scene, new Skybox(1, 2, new float[] {0.25f, 0.5f, 0.75f, 1, 0, 2}))
                .snapshot();
        try (Engine vector = WidthLoader.open(bits, 2);
                Engine sequential = Engines.open(JvmEngines.SEQUENTIAL)) {
            assertThat(PictureDifference.between(argb(vector, input), argb(sequential, input)))
                    .matches(PictureDifference::isWithinBound, "is within the design's bound");
            for (float channel : radiance(vector, input)) {
                assertThat(channel).isFinite().isNotNegative();
            }
        }
    }

    private static int[] argb(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        engine.render(input, frame);
        return frame.argb();
    }

    private static float[] radiance(Engine engine, FrameInput input) {
        Frame frame = Frame.ofRadiance(input.width(), input.rows());
        engine.render(input, frame);
        return frame.radiance();
    }
}
