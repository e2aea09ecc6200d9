package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

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
import dev.twister.world.SceneImages;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/**
 * Checks the oracle itself against closed forms, with a picture of one pixel whose ray goes straight ahead, or straight
 * down, over a ground at y = 0 under a light at height 10.
 */
class OracleTest {
    private static final double MATTE = 0;
    private static final Skybox SKY = new Skybox(1, 1, new float[] {0.25f, 0.5f, 0.75f});
    private static final Camera AHEAD = Camera.of(new Vector3(0.5, 5, -5), 0, 0, 60);
    private static final Camera DOWN = Camera.of(new Vector3(0.5, 5, 0.5), 0, 90, 60);

    @Test
    void missIsTheSky() {
        assertThat(middle(AHEAD, 0, MATTE)).isEqualTo(new Rgb(0.25, 0.5, 0.75));
    }

    @Test
    void groundBelowTheLightIsItsColorTimesTheCosine() {
        double cosine = 10 / Math.sqrt(100.5);
        assertThat(middle(DOWN, 0, MATTE).red()).isCloseTo(0.8 * cosine, within(1e-7));
    }

    @Test
    void shadowLeavesTheAmbientPart() {
        Sphere blocker = sphere(0.25, 8, 0.25, 1.5, MATTE);
        assertThat(middle(DOWN, 0, MATTE, blocker).red()).isCloseTo(0.8 * 0.1, within(1e-7));
    }

    @Test
    void highlightIsBlinnPhongs() {
        double cosine = 10 / Math.sqrt(100.5);
        double cosineOfHalf = Math.cos(Math.acos(cosine) / 2);
        double highlight = (8 + 64) / (8 * Math.PI) * Math.pow(cosineOfHalf, 64) * 64 / 128;
        assertThat(middle(DOWN, 0, 64).red()).isCloseTo(0.8 * cosine + highlight, within(1e-6));
    }

    @Test
    void perfectMirrorShowsTheSkyAndTheHighlight() {
        double cosine = 10 / Math.sqrt(100.5);
        double highlight = (8 + 128) / (8 * Math.PI) * Math.pow(Math.cos(Math.acos(cosine) / 2), 128);
        assertThat(middle(DOWN, 1, 128).green()).isCloseTo(0.5 * cosine + highlight, within(1e-6));
    }

    /** Seen from below, the sphere's underside is in the plane's shadow; beyond the plane's border it is lit. */
    @Test
    void planeHidesALightOnTheOtherSide() {
        Camera down = Camera.of(new Vector3(0, 5, 0), 0, 90, 60);
        Sphere sphere = sphere(0, -3, 0, 1, MATTE);
        assertThat(middle(down.withPosition(new Vector3(0, -0.5, 0)), 0, MATTE, sphere)
                        .red())
                .isCloseTo(0.5 * 0.1, within(1e-7));
        assertThat(new Oracle(
                                scene(down.withPosition(new Vector3(0, -0.5, 0)), 0, MATTE, sphere)
                                        .withGround(Ground.of(20, -10, new Rgb(0, 0, 0), new Rgb(0, 0, 0), MATTE)),
                                SKY)
                        .radiance(0, 0)
                        .red())
                .isCloseTo(0.5, within(1e-7));
    }

    @Test
    void lightIsItsOwnColor() {
        Camera below = Camera.of(new Vector3(0, 5, 0), 0, -90, 60);
        assertThat(middle(below, 0, MATTE)).isEqualTo(new Rgb(1, 1, 1));
    }

    @Test
    void sphereAroundTheCameraIsNotSeen() {
        assertThat(middle(AHEAD, 0, MATTE, sphere(0.5, 5, -5, 2, MATTE))).isEqualTo(new Rgb(0.25, 0.5, 0.75));
    }

    /** From the center of a clear glass ball: straight through, plus F from the far wall at the last bounce. */
    @Test
    void glassIsSeenFromInside() {
        double lit = 7 / Math.sqrt(0.5 * 0.5 + 5 * 5 + 7 * 7);
        double reflectance = 1.0 / 25;
        assertThat(middle(AHEAD, 1, MATTE, glass(sphere(0.5, 5, -5, 2, MATTE), 1))
                        .red())
                .isCloseTo(0.5 * (reflectance * lit + (1 - reflectance) * 0.25), within(1e-7));
    }

    @Test
    void glassLetsAPartOfTheLightPass() {
        double cosine = 10 / Math.sqrt(100.5);
        Sphere blocker = glass(sphere(0.25, 8, 0.25, 1.5, MATTE), 0.25);
        assertThat(middle(DOWN, 0, MATTE, blocker).red()).isCloseTo(0.8 * cosine * 0.25, within(1e-7));
    }

    /** At normal incidence, a transmitting plane reflects F and shows the sky below. */
    @Test
    void planeOfGlassIsASheet() {
        Scene scene = scene(DOWN, 1, MATTE);
        Material glass = scene.ground().material().withTransmission(1);
        assertThat(new Oracle(scene.withGround(scene.ground().withMaterial(glass)), SKY)
                        .radiance(0, 0)
                        .blue())
                .isCloseTo(0.75 * (1.0 / 25 + 24.0 / 25 * 0.8), within(1e-7));
    }

    /** The texture's center is straight ahead, with its right half on the right. */
    @Test
    void textureReadsFromOutside() {
        Path file = Path.of("halves.png");
        Skybox halves = new Skybox(4, 1, new float[] {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1});
        Sphere ball = sphere(0, 5, 0, 2, MATTE);
        Sphere textured = ball.withMaterial(ball.material().withTexture(file));
        SceneImages images = new SceneImages(SKY, Map.of(file, halves));
        Camera camera = AHEAD.withPosition(new Vector3(0, 5, -5));
        for (double x : new double[] {-1.5, 0, 1.5}) {
            Scene scene = scene(camera.withPosition(new Vector3(x, 5, -5)), 0, MATTE, textured)
                    .withShading(new Shading(1));
            assertThat(new Oracle(new LitScene(scene, images)).radiance(0, 0).red())
                    .isCloseTo(x < 0 ? 0 : x > 0 ? 0.5 : 0.25, within(1e-7));
        }
    }

    @Test
    void lensBendsRaysToTheFocus() {
        OracleCamera camera = new OracleCamera(AHEAD.withAperture(0.5).withFocusDistance(7), 3, 2);
        OracleCamera pinhole = new OracleCamera(AHEAD, 3, 2);
        Ray sharp = pinhole.ray(2.5, 0.25, new SampleNumbers(0, 0, 0)).ray();
        Vector focus = sharp.at(7 / sharp.direction().z());
        for (int item = 0; item < 10; item++) {
            Ray bent = camera.ray(2.5, 0.25, new SampleNumbers(2, 0, item)).ray();
            assertThat(bent.origin().minus(sharp.origin()).length()).isLessThanOrEqualTo(0.5);
            assertThat(bent.origin().z()).isEqualTo(sharp.origin().z());
            assertThat(bent.at(7 / bent.direction().z()).minus(focus).length()).isLessThan(1e-12);
        }
    }

    @Test
    void spansAreNarrowAwayFromEdges() {
        PixelSpan span = new Oracle(scene(DOWN, 0, 64), SKY).span(0, 0);
        assertThat(PictureDifference.channelDifference(span.lowest(), span.highest()))
                .isLessThanOrEqualTo(1);
    }

    private static Rgb middle(Camera camera, int bounces, double groundReflectivity, Sphere... spheres) {
        return new Oracle(scene(camera, bounces, groundReflectivity, spheres), SKY).radiance(0, 0);
    }

    private static Scene scene(Camera camera, int bounces, double groundReflectivity, Sphere... spheres) {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(camera)
                .withLights(Lights.of(Light.of(new Vector3(0, 10, 0), 0.5, new Rgb(1, 1, 1))))
                .withGround(Ground.of(20, 0, new Rgb(0.8, 0.8, 0.8), new Rgb(0.3, 0.3, 0.3), groundReflectivity))
                .withSpheres(List.of(spheres))
                .withShading(new Shading(0.1))
                .withRendering(Rendering.DEFAULT.withSize(1, 1).withBounces(bounces));
    }

    private static Sphere glass(Sphere sphere, double transmission) {
        return sphere.withMaterial(sphere.material().withTransmission(transmission));
    }

    private static Sphere sphere(double x, double y, double z, double radius, double reflectivity) {
        return Sphere.of(new Vector3(x, y, z), radius, new Rgb(0.5, 0.5, 0.5), reflectivity);
    }
}
