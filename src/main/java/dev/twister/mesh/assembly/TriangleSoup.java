package dev.twister.mesh.assembly;

import dev.twister.mesh.Box;
import dev.twister.mesh.input.Warnings;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;

/**
 * Triangles as listed in a file. Positions, normals and texture coordinates have separate numbers, or the same number
 * per vertex if only {@link #triangle(int, int, int)} is called.
 */
public final class TriangleSoup {
    public static final int NONE = -1;

    private static final double TEXTURE_COORDINATE = 1e6;

    /** As in the file, until {@link #center} is called. */
    public final DoubleList positions;

    /** The positions relative to their center, in Twister's axes; empty until {@link #center} is called. */
    final FloatList places = new FloatList();

    public final FloatList normals;
    public final FloatList textureCoordinates;

    /** Further sets of texture coordinates, numbered as the first. */
    public final List<FloatList> furtherCoordinates = new ArrayList<>();

    /** Red, green, blue and opacity. */
    public final FloatList colors = new FloatList();

    /** Vectors, and a sign for each; numbered as the positions. */
    public final FloatList tangents = new FloatList();

    public final FloatList tangentSigns = new FloatList();

    /** Position number per corner. */
    IntList positionOf;

    /** Normal number per corner; empty if it equals the position's number. */
    IntList normalOf = new IntList();

    /** Texture coordinate number per corner; empty if it equals the position's number. */
    final IntList textureOf = new IntList();

    /** Color number per corner; empty if it equals the position's number. */
    public final IntList colorOf = new IntList();

    /** Material number per triangle; empty if all are 0. */
    public final IntList materialOf = new IntList();

    /** Whether {@link #vertexPositions} and {@link #vertexNormals} are kept, and triangles without area. */
    public boolean traced;

    /** The position's number of each vertex of the mesh that it becomes. */
    public final IntList vertexPositions = new IntList();

    /**
     * The normal's number of each vertex, or {@link #NONE}; those from the number of given normals on are generated.
     */
    public final IntList vertexNormals = new IntList();

    private int unusablePositions;

    /** With initial capacity for a number of vertices and triangles. */
    public TriangleSoup(int vertices, int triangles) {
        positions = new DoubleList(3 * vertices);
        normals = new FloatList();
        textureCoordinates = new FloatList();
        positionOf = new IntList(3 * triangles);
    }

    public int vertices() {
        return positions.size() / 3;
    }

    public int triangles() {
        return positionOf.size() / 3;
    }

    public void position(double x, double y, double z) {
        positions.add(x);
        positions.add(y);
        positions.add(z);
    }

    /** Adds a position that the file spoils; triangles with it are dropped as degenerate. */
    public void missingPosition() {
        unusablePositions++;
        position(Double.NaN, Double.NaN, Double.NaN);
    }

    /** Warns of positions that the file spoils. */
    public void warnOfUnusable(Warnings warnings) {
        if (unusablePositions > 0) {
            warnings.add("vertices with coordinates that are not numbers from -1e9 to 1e9: " + unusablePositions
                    + "; not read, nor triangles with them");
        }
    }

    /** Adds a normal of any length; a zero or non-finite one counts as missing. */
    public void normal(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        double factor = length > 0 && length < Double.POSITIVE_INFINITY ? 1 / length : 0;
        normals.add(factor == 0 ? 0 : (float) (x * factor));
        normals.add(factor == 0 ? 0 : (float) (y * factor));
        normals.add(factor == 0 ? 0 : (float) (z * factor));
    }

    /** Adds texture coordinates with v down; unusable values become 0. */
    public void textureCoordinates(double u, double v) {
        textureCoordinates.add(usable(u));
        textureCoordinates.add(usable(v));
    }

    /** Adds texture coordinates of a further set, from 1 on. */
    public void furtherCoordinates(int set, double u, double v) {
        while (furtherCoordinates.size() < set) {
            furtherCoordinates.add(new FloatList());
        }
        furtherCoordinates.get(set - 1).add(usable(u));
        furtherCoordinates.get(set - 1).add(usable(v));
    }

    /** Adds a linear color; values outside [0, 1] are clamped, unusable ones become 0. */
    public void color(double red, double green, double blue, double opacity) {
        for (double value : new double[] {red, green, blue, opacity}) {
            colors.add(value >= 0 ? (float) Math.min(value, 1) : 0);
        }
    }

    /** Gives all corners of the triangles from a number on the last color added. */
    public void paint(int firstTriangle) {
        for (int corner = 3 * firstTriangle; corner < positionOf.size(); corner++) {
            colorOf.add(colors.size() / 4 - 1);
        }
    }

    private static float usable(double value) {
        return Math.abs(value) <= TEXTURE_COORDINATE ? (float) value : 0;
    }

    public void triangle(int a, int b, int c) {
        positionOf.add(a);
        positionOf.add(b);
        positionOf.add(c);
    }

    public void corner(int position, int normal, int texture) {
        positionOf.add(position);
        normalOf.add(normal);
        textureOf.add(texture);
    }

    boolean hasOneNumbering() {
        return normalOf.size() == 0;
    }

    /** The normal's number at a corner, or {@link #NONE}. */
    int normalAt(int corner) {
        int index = hasOneNumbering() ? positionOf.get(corner) : normalOf.get(corner);
        return 3L * index + 2 < normals.size() && index >= 0 && hasLength(index) ? index : NONE;
    }

    private boolean hasLength(int normal) {
        return normals.get(3 * normal) != 0 || normals.get(3 * normal + 1) != 0 || normals.get(3 * normal + 2) != 0;
    }

    /** The number of the texture coordinates at a corner, or {@link #NONE}. */
    int textureAt(int corner) {
        int index = textureOf.size() == 0 ? positionOf.get(corner) : textureOf.get(corner);
        return 2L * index + 1 < textureCoordinates.size() ? index : NONE;
    }

    /** The number of the color at a corner, or {@link #NONE}. */
    int colorAt(int corner) {
        int index = colorOf.size() == 0 ? positionOf.get(corner) : colorOf.get(corner);
        return 4L * index + 3 < colors.size() ? index : NONE;
    }

    int materialAt(int triangle) {
        return materialOf.size() == 0 ? 0 : materialOf.get(triangle);
    }

    /**
     * Makes the positions floats. Where triangles are far from the file's origin for their size, floats would be too
     * coarse, so they become relative to a center.
     *
     * @return the center in the file's axes, {@link Vector3#ZERO} for triangles near the origin
     */
    Vector3 center() {
        Vector3 center = SoupCenter.of(bounds());
        for (int vertex = 0; vertex < vertices(); vertex++) {
            places.add((float) (positions.get(3 * vertex) - center.x()));
            places.add((float) (positions.get(3 * vertex + 1) - center.y()));
            places.add((float) (positions.get(3 * vertex + 2) - center.z()));
        }
        return center;
    }

    private Box bounds() {
        BitSet used = new BitSet(vertices());
        for (int corner = 0; corner < positionOf.size(); corner++) {
            used.set(positionOf.get(corner));
        }
        Box bounds = Box.NONE;
        for (int vertex = used.nextSetBit(0); vertex >= 0; vertex = used.nextSetBit(vertex + 1)) {
            Vector3 point = at(vertex);
            bounds = Double.isNaN(point.x()) ? bounds : bounds.with(point);
        }
        return bounds;
    }

    private Vector3 at(int vertex) {
        return new Vector3(positions.get(3 * vertex), positions.get(3 * vertex + 1), positions.get(3 * vertex + 2));
    }

    /** Converts all vectors, and restores the winding of the triangles. */
    void turn(Axes axes) {
        axes.turn(places.storage(), places.size());
        axes.turn(normals.storage(), normals.size());
        axes.turn(tangents.storage(), tangents.size());
        for (int vertex = 0; vertex < tangentSigns.size(); vertex++) {
            tangentSigns.set(vertex, -tangentSigns.get(vertex));
        }
        for (IntList corners : Arrays.asList(positionOf, normalOf, textureOf, colorOf)) {
            for (int b = 1; b < corners.size(); b += 3) {
                int swapped = corners.get(b);
                corners.set(b, corners.get(b + 1));
                corners.set(b + 1, swapped);
            }
        }
    }

    /** Drops triangles without area, unless they are traced; returns their number. */
    int dropDegenerate() {
        Face face = new Face();
        float[] floats = places.storage();
        int kept = 0;
        int triangles = triangles();
        for (int triangle = 0; triangle < triangles; triangle++) {
            int corner = 3 * triangle;
            boolean hasArea =
                    face.set(floats, positionOf.get(corner), positionOf.get(corner + 1), positionOf.get(corner + 2));
            if (hasArea || (traced && hasPlaces(corner))) {
                if (kept < triangle) {
                    move(triangle, kept);
                }
                kept++;
            }
        }
        positionOf.cut(3 * kept);
        normalOf.cut(Math.min(normalOf.size(), 3 * kept));
        textureOf.cut(Math.min(textureOf.size(), 3 * kept));
        colorOf.cut(Math.min(colorOf.size(), 3 * kept));
        materialOf.cut(Math.min(materialOf.size(), kept));
        return triangles - kept;
    }

    private boolean hasPlaces(int corner) {
        return !Float.isNaN(places.get(3 * positionOf.get(corner))
                + places.get(3 * positionOf.get(corner + 1))
                + places.get(3 * positionOf.get(corner + 2)));
    }

    private void move(int from, int to) {
        for (IntList corners : Arrays.asList(positionOf, normalOf, textureOf, colorOf)) {
            for (int i = 0; i < 3 && corners.size() > 0; i++) {
                corners.set(3 * to + i, corners.get(3 * from + i));
            }
        }
        if (materialOf.size() > 0) {
            materialOf.set(to, materialOf.get(from));
        }
    }

    /** The center that positions are relative to, so that floats place them as exactly as near the origin. */
    private static final class SoupCenter {
        /** Up to this many times half of the largest side away, floats at the origin are about as exact. */
        private static final double NEAR = 4;

        private SoupCenter() {}

        /**
         * The center of a box, rounded to a multiple of a power of two, so that floats of the file stay exact; zero for
         * a box near the origin.
         */
        static Vector3 of(Box bounds) {
            double half = largest(bounds.half());
            Vector3 center = bounds.center();
            if (!(half > 0) || !(largest(center) > NEAR * half)) {
                return Vector3.ZERO;
            }
            double unit = Math.scalb(1.0, Math.getExponent(half));
            return new Vector3(rounded(center.x(), unit), rounded(center.y(), unit), rounded(center.z(), unit));
        }

        private static double rounded(double value, double unit) {
            return Math.rint(value / unit) * unit;
        }

        private static double largest(Vector3 vector) {
            return Math.max(Math.abs(vector.x()), Math.max(Math.abs(vector.y()), Math.abs(vector.z())));
        }
    }
}
