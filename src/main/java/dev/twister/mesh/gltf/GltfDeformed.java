package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.mesh.TriangleMesh;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.scene.Vector3;
import java.util.Arrays;
import java.util.List;

/**
 * A mesh whose vertices move: how it is made of the vertices of a primitive.
 *
 * @param pose at rest
 * @param center what its positions are relative to, in Twister's axes
 * @param vertexOf the primitive's vertex of each of its vertices
 * @param normalOf the normal of each: the primitive's, or from their number on one that is generated
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record GltfDeformed(GltfDeformation deformation, GltfPose pose, Vector3 center, int[] vertexOf, int[] normalOf) {
    /**
     * The mesh with its vertices moved. A vertex that would leave the range of coordinates stays where it is at rest.
     *
     * @param weights of the morph targets
     * @param movements of the joints of its skin, if there is one
     */
    TriangleMesh moved(TriangleMesh rest, double[] weights, List<Affine> movements) {
        GltfDeformation.Moved moved = deformation.moved(weights, movements);
        float[] positions = new float[rest.positions().length];
        for (int vertex = 0; vertex < vertexOf.length; vertex++) {
            int from = 3 * vertexOf[vertex];
            double x = moved.positions()[from];
            double y = moved.positions()[from + 1];
            double z = moved.positions()[from + 2];
            if (MeshLimits.areCoordinates(x, y, z)) {
                positions[3 * vertex] = (float) (x - center.x());
                positions[3 * vertex + 1] = (float) (y - center.y());
                positions[3 * vertex + 2] = (float) (-z - center.z());
            } else {
                System.arraycopy(rest.positions(), 3 * vertex, positions, 3 * vertex, 3);
            }
        }
        float[] normals = rest.normals().length == 0 ? rest.normals() : normals(rest, positions, moved.normals());
        float[] tangents = rest.tangents().length == 0 ? rest.tangents() : tangents(rest, moved.tangents());
        return new TriangleMesh(positions, normals, rest.textureCoordinates(), rest.colors(), tangents, rest.corners());
    }

    private float[] normals(TriangleMesh rest, float[] positions, double[] given) {
        double[] generated = generated(rest.corners(), positions, given.length / 3);
        float[] normals = new float[rest.normals().length];
        for (int vertex = 0; vertex < normalOf.length; vertex++) {
            int number = normalOf[vertex];
            boolean isGiven = 3 * number < given.length;
            double[] source = isGiven ? given : generated;
            int at = isGiven ? 3 * number : 3 * number - given.length;
            write(
                    source[at],
                    source[at + 1],
                    isGiven ? -source[at + 2] : source[at + 2],
                    normals,
                    rest.normals(),
                    3 * vertex);
        }
        return normals;
    }

    /** The sums of the normals of faces, weighted by their angles, for each normal that is generated. */
    private double[] generated(int[] corners, float[] positions, int given) {
        int last = Arrays.stream(normalOf).max().orElse(0);
        double[] sums = new double[Math.max(0, 3 * (last + 1 - given))];
        for (int corner = 0; corner < corners.length && sums.length > 0; corner++) {
            int normal = normalOf[corners[corner]] - given;
            if (normal >= 0) {
                int first = corner - corner % 3;
                add(
                        positions,
                        3 * corners[corner],
                        3 * corners[first + (corner + 1) % 3],
                        3 * corners[first + (corner + 2) % 3],
                        sums,
                        3 * normal);
            }
        }
        return sums;
    }

    private static void add(float[] positions, int a, int b, int c, double[] sums, int at) {
        Vector3 origin = vector(positions, a);
        Vector3 u = vector(positions, b).minus(origin);
        Vector3 v = vector(positions, c).minus(origin);
        Vector3 normal = u.cross(v);
        double length = normal.length();
        if (length > 0) {
            Vector3 weighted = normal.times(Math.atan2(length, u.dot(v)) / length);
            sums[at] += weighted.x();
            sums[at + 1] += weighted.y();
            sums[at + 2] += weighted.z();
        }
    }

    private static Vector3 vector(float[] positions, int at) {
        return new Vector3(positions[at], positions[at + 1], positions[at + 2]);
    }

    private float[] tangents(TriangleMesh rest, double[] moved) {
        float[] tangents = rest.tangents().clone();
        float[] vector = new float[3];
        for (int vertex = 0; vertex < vertexOf.length; vertex++) {
            int from = 3 * vertexOf[vertex];
            System.arraycopy(tangents, 4 * vertex, vector, 0, 3);
            write(moved[from], moved[from + 1], -moved[from + 2], vector, vector.clone(), 0);
            System.arraycopy(vector, 0, tangents, 4 * vertex, 3);
        }
        return tangents;
    }

    /** Writes a unit vector; the one at rest where there is no direction. */
    private static void write(double x, double y, double z, float[] to, float[] rest, int at) {
        double length = Math.sqrt(x * x + y * y + z * z);
        boolean usable = length > 0 && length < Double.POSITIVE_INFINITY;
        to[at] = usable ? (float) (x / length) : rest[at];
        to[at + 1] = usable ? (float) (y / length) : rest[at + 1];
        to[at + 2] = usable ? (float) (z / length) : rest[at + 2];
    }
}
