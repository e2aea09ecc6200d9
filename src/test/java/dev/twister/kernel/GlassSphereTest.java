package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Traces a ray through a glass sphere, surface by surface. */
class GlassSphereTest {
    /** Light and plane out of the way, and a sphere of radius 2 at (1, 2, 10). */
    private static final float[] PLACES = {0, 0, -99, 1, 0, -99, 0, 1, 1, 2, 10, 2};

    private static final int BODIES = 3;
    private static final double RADIUS = 2;

    /**
     * A ray along z that would pass the center at distance b is deflected twice by the difference of the angles with
     * sines b / R and b / nR, and leaves at the same distance from the center.
     */
    @ParameterizedTest
    @CsvSource({"0.2, 1.5", "1, 1.5", "1.9, 1.5", "1.99, 1.5", "1, 1.333", "1.5, 2.42", "1.5, 4", "1.5, 1"})
    void rayLeavesWhereSnellSays(double b, float ior) {
        float[] looks = new float[Layout.LOOK_STRIDE * BODIES];
        int look = Layout.LOOK_STRIDE * Layout.FIRST_SPHERE;
        looks[look] = looks[look + 1] = looks[look + 2] = 1;
        looks[look + Layout.LOOK_TRANSMISSION] = 1;
        looks[look + Layout.LOOK_IOR] = ior;
        float[] path = Paths.ray(new float[] {1, (float) (2 + b), 0}, new float[] {0, 0, 1}, Layout.NOTHING);
        passOn(path, looks);
        assertThat(path[Layout.INSIDE]).isEqualTo(Layout.CROSSED_INTO);
        passOn(path, looks);
        assertThat(path[Layout.INSIDE]).isEqualTo(Layout.CROSSED_OUT);

        double turn = 2 * (Math.asin(b / RADIUS) - Math.asin(b / RADIUS / ior));
        assertThat(path[Layout.DIRECTION]).isZero();
        assertThat((double) path[Layout.DIRECTION + 1]).isCloseTo(-Math.sin(turn), within(2e-5));
        assertThat((double) path[Layout.DIRECTION + 2]).isCloseTo(Math.cos(turn), within(2e-5));
        double y = path[Layout.ORIGIN + 1] - 2.0;
        double z = path[Layout.ORIGIN + 2] - 10.0;
        assertThat(y * path[Layout.DIRECTION + 2] - z * path[Layout.DIRECTION + 1])
                .as("distance from the center")
                .isCloseTo(b, within(2e-5));
    }

    /** Continues with the refracted ray, whichever of the two branches is pending. */
    private static void passOn(float[] path, float[] looks) {
        float[] scratch = new float[Layout.SCRATCH_LENGTH];
        path[Layout.WAITING] = 0;
        float[] frame = Paths.frame(BODIES);
        float[] none = new float[0];
        int body = Hit.find(path, scratch, frame, PLACES, looks, none, Variant.MATERIALS);
        assertThat(body).isEqualTo(Layout.FIRST_SPHERE);
        Surface.find(path, body, frame, PLACES, none, Variant.MATERIALS);
        SurfaceLook.find(path, body, frame, looks, none, Variant.MATERIALS);
        Surface.face(path, body, frame, Variant.MATERIALS);
        Facet.find(path, frame);
        Branch.split(path, body, 0f, 1f, 1f, scratch, looks);
        boolean crossed = path[Layout.INSIDE] == Layout.CROSSED_INTO || path[Layout.INSIDE] == Layout.CROSSED_OUT;
        if (path[Layout.WAITING] > 0 && !crossed) {
            Branch.resume(path, scratch);
        }
    }
}
