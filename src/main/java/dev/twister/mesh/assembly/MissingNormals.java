package dev.twister.mesh.assembly;

import java.util.Arrays;

/**
 * Generates normals that a file lacks. Adjacent triangles whose planes meet at no more than the given angle get a
 * common normal at each shared corner: the mean of their normals, weighted by the triangles' angles at the corner.
 */
final class MissingNormals {
    private final TriangleSoup soup;
    private final float[] positions;
    private final int[] corners;
    private final int cornerCount;
    private final double leastCosine;
    private final float[] faceNormals;
    private final int[] parents;

    private MissingNormals(TriangleSoup soup, double smoothDegrees) {
        this.soup = soup;
        this.positions = soup.places.storage();
        this.corners = soup.positionOf.storage();
        this.cornerCount = soup.positionOf.size();
        // A tolerance, so that rounding does not exclude planes at exactly the given angle.
        this.leastCosine = Math.cos(Math.toRadians(smoothDegrees)) - 1e-6;
        this.faceNormals = faceNormals();
        this.parents = new int[cornerCount];
        Arrays.setAll(parents, corner -> corner);
    }

    /**
     * Generates the normals of corners that have none. Does nothing if no corner has one and the angle is 0, because
     * flat triangles need none.
     */
    static void make(TriangleSoup soup, double smoothDegrees) {
        int corners = soup.positionOf.size();
        int missing = 0;
        for (int corner = 0; corner < corners; corner++) {
            missing += soup.normalAt(corner) == TriangleSoup.NONE ? 1 : 0;
        }
        if (missing == 0 || (missing == corners && smoothDegrees == 0)) {
            return;
        }
        MissingNormals maker = new MissingNormals(soup, smoothDegrees);
        if (smoothDegrees > 0) {
            maker.joinAcrossEdges();
        }
        maker.assign();
    }

    private float[] faceNormals() {
        Face face = new Face();
        float[] normals = new float[cornerCount];
        for (int a = 0; a < cornerCount; a += 3) {
            if (face.set(positions, corners[a], corners[a + 1], corners[a + 2])) {
                normals[a] = (float) face.x();
                normals[a + 1] = (float) face.y();
                normals[a + 2] = (float) face.z();
            } else {
                normals[a + 1] = 1;
            }
        }
        return normals;
    }

    private void joinAcrossEdges() {
        int[] places = weldedPositions();
        int[] table = new int[TableHash.tableSize(cornerCount)];
        int mask = table.length - 1;
        for (int corner = 0; corner < cornerCount; corner++) {
            int from = places[corner];
            int to = places[next(corner)];
            int slot = TableHash.of(Math.min(from, to), Math.max(from, to), 0) & mask;
            while (table[slot] > 0 && !isSameEdge(places, table[slot] - 1, from, to)) {
                slot = slot + 1 & mask;
            }
            if (table[slot] > 0) {
                joinOver(places, corner, table[slot] - 1);
            }
            table[slot] = corner + 1;
        }
    }

    private static boolean isSameEdge(int[] places, int corner, int from, int to) {
        int otherFrom = places[corner];
        int otherTo = places[next(corner)];
        return (otherFrom == from && otherTo == to) || (otherFrom == to && otherTo == from);
    }

    /**
     * Joins the corners of two triangles at both ends of their common edge, if they traverse it in opposite directions.
     */
    private void joinOver(int[] places, int corner, int other) {
        if (places[corner] == places[next(other)] && cosine(corner, other) >= leastCosine) {
            join(corner, next(other));
            join(next(corner), other);
        }
    }

    private double cosine(int corner, int other) {
        int a = corner - corner % 3;
        int b = other - other % 3;
        return (double) faceNormals[a] * faceNormals[b]
                + (double) faceNormals[a + 1] * faceNormals[b + 1]
                + (double) faceNormals[a + 2] * faceNormals[b + 2];
    }

    private void join(int a, int b) {
        int rootA = root(a);
        int rootB = root(b);
        parents[Math.max(rootA, rootB)] = Math.min(rootA, rootB);
    }

    private int root(int corner) {
        int place = corner;
        while (parents[place] != place) {
            parents[place] = parents[parents[place]];
            place = parents[place];
        }
        return place;
    }

    /** Per corner, a number that all corners at equal positions share. */
    private int[] weldedPositions() {
        PositionIndex index = new PositionIndex(new DoubleList());
        int[] numbers = new int[soup.vertices()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = index.of(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
        }
        int[] places = new int[cornerCount];
        Arrays.setAll(places, corner -> numbers[corners[corner]]);
        return places;
    }

    private void assign() {
        int given = soup.normals.size() / 3;
        IntList normalOf = new IntList(cornerCount);
        FloatList sums = new FloatList();
        IntList firsts = new IntList();
        boolean flat = leastCosine > 1 - 2e-6;
        for (int corner = 0; corner < cornerCount; corner++) {
            int own = soup.normalAt(corner);
            // The root of a joined corner precedes it; a flat triangle has one normal for all three corners.
            int root = flat ? corner - corner % 3 : root(corner);
            if (own != TriangleSoup.NONE) {
                normalOf.add(own);
            } else if (root < corner && normalOf.get(root) >= given) {
                normalOf.add(normalOf.get(root));
                addFace(sums, 3 * (normalOf.get(root) - given), corner);
            } else {
                normalOf.add(given + sums.size() / 3);
                sums.add(0);
                sums.add(0);
                sums.add(0);
                firsts.add(corner - corner % 3);
                addFace(sums, sums.size() - 3, corner);
            }
        }
        for (int i = 0; i < firsts.size(); i++) {
            addNormal(sums, 3 * i, firsts.get(i));
        }
        if (soup.hasOneNumbering() && soup.textureCoordinates.size() > 0) {
            for (int corner = 0; corner < cornerCount; corner++) {
                soup.textureOf.add(corners[corner]);
            }
        }
        soup.normalOf = normalOf;
    }

    /** Adds a sum as a normal, or the first face's normal if the sum cancels out. */
    private void addNormal(FloatList sums, int at, int face) {
        double x = sums.get(at);
        double y = sums.get(at + 1);
        double z = sums.get(at + 2);
        if (x * x + y * y + z * z > 1e-12) {
            soup.normal(x, y, z);
        } else {
            soup.normal(faceNormals[face], faceNormals[face + 1], faceNormals[face + 2]);
        }
    }

    private void addFace(FloatList sums, int at, int corner) {
        int face = corner - corner % 3;
        float weight = (float) angle(corner);
        for (int axis = 0; axis < 3; axis++) {
            sums.set(at + axis, sums.get(at + axis) + weight * faceNormals[face + axis]);
        }
    }

    /** The triangle's angle at a corner, in radians. */
    private double angle(int corner) {
        int at = 3 * corners[corner];
        int left = 3 * corners[next(corner)];
        int right = 3 * corners[next(next(corner))];
        double dot = 0;
        double leftSquare = 0;
        double rightSquare = 0;
        for (int axis = 0; axis < 3; axis++) {
            double u = (double) positions[left + axis] - positions[at + axis];
            double v = (double) positions[right + axis] - positions[at + axis];
            dot += u * v;
            leftSquare += u * u;
            rightSquare += v * v;
        }
        double cosine = dot / Math.sqrt(leftSquare * rightSquare);
        // Never 0, so that an isolated sliver still gets a normal.
        return Math.max(1e-6, Math.acos(Math.clamp(cosine, -1.0, 1.0)));
    }

    private static int next(int corner) {
        return corner % 3 == 2 ? corner - 2 : corner + 1;
    }
}
