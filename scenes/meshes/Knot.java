import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Makes knot.obj and knot.mtl beside itself: {@code java scenes/meshes/Knot.java}. A (2, 3) torus knot of six pieces
 * with round ends, glass and metal in turn.
 */
public final class Knot {
    private static final int PIECES = 6;
    private static final int RINGS = 26;
    private static final int CAP_RINGS = 4;
    private static final int SIDES = 16;
    private static final double TUBE_RADIUS = 0.3;

    /** Of the whole knot's parameter, between two pieces. */
    private static final double GAP = 0.004;

    private final StringBuilder vertices = new StringBuilder();
    private final StringBuilder faces = new StringBuilder();
    private int vertexCount;

    private Knot() {}

    public static void main(String[] arguments) throws IOException {
        Path folder = Path.of("scenes", "meshes");
        Files.writeString(folder.resolve("knot.obj"), new Knot().obj());
        Files.writeString(folder.resolve("knot.mtl"), """
                # Made by Knot.java
                newmtl glass
                Kd 0.9 0.98 0.96
                Tf 0.9 0.98 0.96
                Ni 1.5
                illum 7

                newmtl gold
                Kd 1 0.78 0.34
                Pr 0.15
                Pm 1
                illum 3
                """);
    }

    private String obj() {
        for (int material = 0; material < 2; material++) {
            faces.append("usemtl ").append(material == 0 ? "glass" : "gold").append('\n');
            for (int piece = material; piece < PIECES; piece += 2) {
                addPiece((piece + GAP / 2) / PIECES, (piece + 1 - GAP / 2) / PIECES);
            }
        }
        return "# Made by Knot.java\nmtllib knot.mtl\n" + vertices + faces;
    }

    /** A tube from one parameter to another, in [0, 1], with a round cap at each end. */
    private void addPiece(double from, double to) {
        double length = length(from, to);
        int first = vertexCount;
        int rings = RINGS + 2 * CAP_RINGS;
        addVertex(at(from), scaled(tangent(from), -1));
        for (int ring = 1; ring < rings; ring++) {
            // The angle from the pole in the caps, a right angle between them.
            double polar = Math.PI / 2 * Math.min(1, (double) Math.min(ring, rings - ring) / CAP_RINGS);
            double inset = TUBE_RADIUS * (1 - Math.cos(polar)) / length;
            double straight = Math.clamp((double) (ring - CAP_RINGS) / RINGS, 0.0, 1.0);
            double capped = TUBE_RADIUS / length;
            double along = ring <= CAP_RINGS
                    ? inset
                    : ring >= rings - CAP_RINGS ? 1 - inset : capped + straight * (1 - 2 * capped);
            double tilt = ring < rings / 2 ? -Math.cos(polar) : Math.cos(polar);
            addRing(from + along * (to - from), TUBE_RADIUS * Math.sin(polar), tilt);
        }
        addVertex(at(to), tangent(to));
        addFaces(first, rings - 1);
    }

    private void addRing(double parameter, double radius, double tilt) {
        double[] center = at(parameter);
        double[] tangent = tangent(parameter);
        double[] side = unit(cross(tangent, new double[] {0, 0, 1}));
        double[] up = cross(side, tangent);
        for (int i = 0; i < SIDES; i++) {
            double angle = 2 * Math.PI * i / SIDES;
            double[] outward = sum(scaled(side, Math.cos(angle)), scaled(up, Math.sin(angle)));
            double level = Math.sqrt(1 - tilt * tilt);
            addVertex(
                    sum(center, scaled(outward, radius)), sum(scaled(outward, level), scaled(tangent, tilt)));
        }
    }

    /** A fan at each pole and quads between the rings, counterclockwise from outside. */
    private void addFaces(int first, int rings) {
        int last = vertexCount - 1;
        for (int i = 0; i < SIDES; i++) {
            int next = (i + 1) % SIDES;
            addFace(first, first + 1 + i, first + 1 + next);
            addFace(last, last - SIDES + next, last - SIDES + i);
            for (int ring = 0; ring + 1 < rings; ring++) {
                int here = first + 1 + ring * SIDES;
                addFace(here + i, here + SIDES + i, here + SIDES + next, here + next);
            }
        }
    }

    private void addVertex(double[] position, double[] normal) {
        vertices.append(String.format(Locale.ROOT, "v %.4f %.4f %.4f\n", position[0], position[1], position[2]));
        vertices.append(String.format(Locale.ROOT, "vn %.3f %.3f %.3f\n", normal[0], normal[1], normal[2]));
        vertexCount++;
    }

    private void addFace(int... corners) {
        faces.append('f');
        for (int corner : corners) {
            faces.append(' ').append(corner + 1).append("//").append(corner + 1);
        }
        faces.append('\n');
    }

    private static double[] at(double parameter) {
        double angle = 2 * Math.PI * parameter;
        double distance = 2 + Math.cos(3 * angle);
        return new double[] {
            0.75 * distance * Math.cos(2 * angle), 0.75 * distance * Math.sin(2 * angle), 0.9 * Math.sin(3 * angle)
        };
    }

    private static double[] tangent(double parameter) {
        return unit(sum(at(parameter + 1e-5), scaled(at(parameter - 1e-5), -1)));
    }

    private static double length(double from, double to) {
        double length = 0;
        for (int i = 0; i < 200; i++) {
            double[] step = sum(
                    at(from + (to - from) * (i + 1) / 200), scaled(at(from + (to - from) * i / 200), -1));
            length += Math.sqrt(dot(step, step));
        }
        return length;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double[] sum(double[] a, double[] b) {
        return new double[] {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    }

    private static double[] scaled(double[] a, double factor) {
        return new double[] {factor * a[0], factor * a[1], factor * a[2]};
    }

    private static double[] unit(double[] a) {
        return scaled(a, 1 / Math.sqrt(dot(a, a)));
    }
}
