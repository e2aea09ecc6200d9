package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class IntersectionTest {
    @Test
    void sphereIsMetAtItsNearSide() {
        assertThat(Intersection.sphere(0, 0, 5, 2, 0, 0, 1)).isEqualTo(3f);
    }

    @Test
    void tangentIsAHit() {
        assertThat(Intersection.sphere(2, 0, 5, 2, 0, 0, 1)).isEqualTo(5f);
    }

    @Test
    void rayJustBesideTheTangentMisses() {
        assertThat(Intersection.sphere(Math.nextUp(2f), 0, 5, 2, 0, 0, 1)).isEqualTo(Intersection.MISS);
    }

    @Test
    void sphereIsNotSeenFromInside() {
        assertThat(Intersection.sphere(0, 0.5f, 1, 2, 0, 0, 1)).isEqualTo(Intersection.MISS);
    }

    @Test
    void sphereIsNotSeenFromItsOwnSurface() {
        assertThat(Intersection.sphere(0, 0, 2, 2, 0, 0, 1)).isEqualTo(Intersection.MISS);
    }

    /**
     * A sphere is hit from its own surface in all inward directions or in none, whichever way rounding puts the origin.
     */
    @Test
    void sphereFromItsSurfaceIsNotSpeckled() {
        Random random = new Random(20261125);
        for (int i = 0; i < 200; i++) {
            float x = random.nextFloat() - 0.5f;
            float y = random.nextFloat() - 0.5f;
            float z = random.nextFloat() + 0.1f;
            float radius = (float) Math.sqrt((double) x * x + y * y + z * z);
            Set<Boolean> seen = new HashSet<>();
            for (int ray = 0; ray < 200; ray++) {
                float tilt = random.nextFloat() - 0.5f;
                float length = (float) Math.sqrt(1 + tilt * tilt);
                float distance = Intersection.sphere(x, y, z, radius, 0, tilt / length, 1 / length);
                if (z + y * tilt > 0) {
                    seen.add(distance < Intersection.MISS);
                }
            }
            assertThat(seen).hasSizeLessThanOrEqualTo(1);
        }
    }

    @Test
    void sphereBehindIsNotSeen() {
        assertThat(Intersection.sphere(0, 0, -5, 2, 0, 0, 1)).isEqualTo(Intersection.MISS);
    }

    @Test
    void smallAndFarSphereKeepsItsDigits() {
        float z = 10_000f;
        assertThat(Intersection.sphere(0.0099f, 0, z, 0.01f, 0, 0, 1)).isLessThan(z);
        assertThat(Intersection.sphere(0.0101f, 0, z, 0.01f, 0, 0, 1)).isEqualTo(Intersection.MISS);
    }

    @ParameterizedTest
    @CsvSource({"5, -1", "-5, 1"})
    void planeIsSeenFromAboveAndBelow(float originY, float directionY) {
        assertThat(Intersection.plane(0, 10, 1, originY, 1, 0, directionY, 0)).isCloseTo(5f, within(0f));
    }

    @ParameterizedTest
    @CsvSource({"5, 0", "-5, 0", "0, 5", "5, -5"})
    void planesBorderIsInside(float x, float z) {
        assertThat(Intersection.plane(0, 10, x, 3, z, 0, -1, 0)).isEqualTo(3f);
    }

    @Test
    void justPastThePlanesBorderIsNothing() {
        assertThat(Intersection.plane(0, 10, 5.0001f, 3, 0, 0, -1, 0)).isEqualTo(Intersection.MISS);
    }

    @ParameterizedTest
    @CsvSource({"3, 0", "3, 1", "0, -1", "0, 0"})
    void planeBesideBehindOrAroundTheRayIsNotSeen(float originY, float directionY) {
        assertThat(Intersection.plane(0, 10, 0, originY, 0, 1, directionY, 0)).isEqualTo(Intersection.MISS);
    }
}
