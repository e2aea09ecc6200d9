package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Rotation;
import dev.twister.scene.Shape;
import dev.twister.scene.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Pictures of meshes without a file. */
class ShapesTest {
    private static final Material GLASS =
            Material.DEFAULT.withColor(new Rgb(1, 1, 1)).withReflectivity(0).withTransmission(1);

    private static final Rendering SMALL = Rendering.DEFAULT.withSize(64, 48).withShadowSamples(4);

    /** A hole, or a triangle that faces inward, would bend or end rays. */
    @ParameterizedTest
    @EnumSource(
            value = Shape.Kind.class,
            mode = EnumSource.Mode.EXCLUDE,
            names = {"QUAD"})
    void glassThatDoesNotRefractIsNotSeen(Shape.Kind kind) {
        Mesh mesh = Mesh.of(Shape.of(kind, 2))
                .withRotation(new Rotation(20, 30, 10))
                .withMaterial(GLASS.withIor(1));
        int[] without = argb(level());
        int[] with = argb(level().mesh(mesh));

        for (int pixel = 0; pixel < with.length; pixel++) {
            for (int shift = 0; shift < 24; shift += 8) {
                int channel = (with[pixel] >> shift & 0xff) - (without[pixel] >> shift & 0xff);
                assertThat(channel).as("pixel %d", pixel).isBetween(-2, 2);
            }
        }
    }

    @Test
    void aQuadFacesTheCamera() {
        Material lamp = Material.DEFAULT
                .withColor(new Rgb(0, 0, 0))
                .withEmission(
                        Material.DEFAULT.emission().withColor(new Rgb(0, 1, 0)).withDoubleSided(false));
        Mesh quad = Mesh.of(new Shape(Shape.Kind.QUAD, new Vector3(2, 1, 0))).withMaterial(lamp);

        assertThat(middle(quad)).isEqualTo(0xff00ff00);
        assertThat(middle(quad.withRotation(new Rotation(180, 0, 0)))).isNotEqualTo(0xff00ff00);
    }

    private static int middle(Mesh mesh) {
        return argb(level().mesh(mesh))[24 * 64 + 32];
    }

    private static int[] argb(SceneBuilder scene) {
        return Twister.render(scene).frame().argb();
    }

    private static SceneBuilder level() {
        return new SceneBuilder()
                .camera(Camera.of(new Vector3(0, 0.5, -5), 0, 5, 40))
                .ground(Ground.of(20, -2, new Rgb(0.8, 0.8, 0.8), new Rgb(0.3, 0.3, 0.3), 0))
                .rendering(SMALL.withBounces(12));
    }
}
