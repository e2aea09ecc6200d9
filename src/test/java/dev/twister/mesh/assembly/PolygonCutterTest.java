package dev.twister.mesh.assembly;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

/** Polygons cut into triangles that cover them exactly. */
class PolygonCutterTest {
    private final DoubleList positions = new DoubleList();
    private final IntList corners = new IntList();

    @Test
    void arrow() {
        corner(0, 0);
        corner(2, -2);
        corner(0, 2);
        corner(-2, -2);
        assertThat(areas()).isEqualTo(4);
    }

    @Test
    void aCornerOnAStraightEdgeKeepsIts() {
        corner(0, 0);
        corner(1, 0);
        corner(2, 0);
        corner(2, 2);
        IntList cut = new PolygonCutter().cut(positions, corners, 4);
        for (int i = 0; i < 6; i += 3) {
            assertThat(area(cut, i)).isEqualTo(1);
        }
    }

    @Test
    void combOf200Teeth() {
        for (int tooth = 0; tooth < 200; tooth++) {
            corner(2 * tooth, 0);
            corner(2 * tooth + 1, 5);
        }
        corner(398, -1);
        corner(0, -1);
        // The comb runs clockwise.
        assertThat(areas()).isEqualTo(-outline());
    }

    @Property(tries = 300)
    void starsInAnyPlane(@ForAll long seed) {
        Random random = new Random(seed);
        int count = 4 + random.nextInt(40);
        double tilt = random.nextDouble(6.28);
        DoubleList places = new DoubleList();
        IntList star = new IntList();
        double expected = 0;
        double[] radii = random.doubles(count, 0.1, 3).toArray();
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * i / count;
            double x = radii[i] * Math.cos(angle);
            places.add((float) (x * Math.cos(tilt)));
            places.add((float) (radii[i] * Math.sin(angle)));
            places.add((float) (x * Math.sin(tilt)));
            star.add(i);
            expected += 0.5 * radii[i] * radii[(i + 1) % count] * Math.sin(2 * Math.PI / count);
        }
        IntList cut = new PolygonCutter().cut(places, star, count);
        assertThat(cut.size()).isEqualTo(3 * (count - 2));
        double sum = 0;
        Face face = new Face();
        float[] storage = new float[places.size()];
        for (int i = 0; i < storage.length; i++) {
            storage[i] = (float) places.get(i);
        }
        for (int i = 0; i < cut.size(); i += 3) {
            face.set(storage, cut.get(i), cut.get(i + 1), cut.get(i + 2));
            double toAxis = face.z() * Math.cos(tilt) - face.x() * Math.sin(tilt);
            assertThat(toAxis).isGreaterThan(0.99);
            sum += area(storage, cut, i);
        }
        assertThat(sum).isCloseTo(expected, offset(1e-3));
    }

    private void corner(float x, float y) {
        corners.add(positions.size() / 3);
        positions.add(x);
        positions.add(y);
        positions.add(0);
    }

    private double areas() {
        IntList cut = new PolygonCutter().cut(positions, corners, corners.size());
        double sum = 0;
        for (int i = 0; i < cut.size(); i += 3) {
            assertThat(area(cut, i) * outline()).isGreaterThan(0);
            sum += Math.abs(area(cut, i));
        }
        return sum;
    }

    /** Positive where the polygon runs counterclockwise. */
    private double outline() {
        double sum = 0;
        for (int i = 0; i < corners.size(); i++) {
            int next = (i + 1) % corners.size();
            sum += positions.get(3 * i) * positions.get(3 * next + 1)
                    - positions.get(3 * next) * positions.get(3 * i + 1);
        }
        return sum / 2;
    }

    private double area(IntList cut, int at) {
        int a = 3 * cut.get(at);
        int b = 3 * cut.get(at + 1);
        int c = 3 * cut.get(at + 2);
        return 0.5
                * ((positions.get(b) - positions.get(a)) * (positions.get(c + 1) - positions.get(a + 1))
                        - (positions.get(c) - positions.get(a)) * (positions.get(b + 1) - positions.get(a + 1)));
    }

    private static double area(float[] places, IntList cut, int at) {
        double[] sides = new double[3];
        for (int i = 0; i < 3; i++) {
            int a = 3 * cut.get(at + i);
            int b = 3 * cut.get(at + (i + 1) % 3);
            sides[i] = Math.sqrt(Math.pow(places[a] - places[b], 2)
                    + Math.pow(places[a + 1] - places[b + 1], 2)
                    + Math.pow(places[a + 2] - places[b + 2], 2));
        }
        double half = (sides[0] + sides[1] + sides[2]) / 2;
        return Math.sqrt(Math.max(0, half * (half - sides[0]) * (half - sides[1]) * (half - sides[2])));
    }
}
