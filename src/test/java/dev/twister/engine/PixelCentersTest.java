package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.oracle.Pictures;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A white sphere straight ahead in the dark must appear in the center of the picture. */
class PixelCentersTest {
    private static final int SIDE = 64;
    private static final Skybox BLACK = new Skybox(1, 1, new float[3]);
    private static final Rgb WHITE = new Rgb(1, 1, 1);

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 16, 17})
    void centeredSphereIsCenteredAtAnyNumberOfSamples(int samples) {
        float[] radiance = Pictures.radiance(JvmEngines.SEQUENTIAL, scene(60, SIDE, samples), BLACK);
        double light = 0;
        double x = 0;
        double y = 0;
        for (int row = 0; row < SIDE; row++) {
            for (int column = 0; column < SIDE; column++) {
                float red = radiance[3 * (SIDE * row + column)];
                light += red;
                x += red * (column + 0.5);
                y += red * (row + 0.5);
            }
        }
        assertThat(x / light).isCloseTo(SIDE / 2.0, within(1e-3));
        assertThat(y / light).isCloseTo(SIDE / 2.0, within(1e-3));
    }

    @Test
    void onePixelSeesWhatIsStraightAhead() {
        assertThat(Pictures.argb(JvmEngines.SEQUENTIAL, scene(20, 1, 1), BLACK)).containsExactly(0xFFFFFFFF);
    }

    private static Scene scene(double fieldOfView, int side, int samples) {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0, 0, 0), 0, 0, fieldOfView))
                .withLights(Lights.of(Light.of(new Vector3(0, 0, -50), 0.5, WHITE)))
                .withGround(Ground.of(0.001, -1000, WHITE, WHITE, 0))
                .withSpheres(List.of(Sphere.of(new Vector3(0, 0, 5), 1, WHITE, 0)))
                .withShading(new Shading(1))
                .withRendering(Rendering.DEFAULT
                        .withSize(side, side)
                        .withShadowSamples(1)
                        .withBounces(1)
                        .withSamplesPerPixel(samples));
    }
}
