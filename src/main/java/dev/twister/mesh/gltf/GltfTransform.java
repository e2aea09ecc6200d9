package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.mesh.assembly.Axes;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.scene.Vector3;
import java.util.Arrays;

/** The transforms of glTF nodes. */
final class GltfTransform {
    private static final double FLAT = 1e-12;

    private GltfTransform() {}

    /** The transform from a node's coordinates to its parent's, in the file's axes. */
    static Affine of(GltfPlace node) {
        if (node.at("matrix").exists()) {
            double[] m = node.at("matrix").numbersOr(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
            return new Affine(column(m, 0), column(m, 4), column(m, 8), column(m, 12));
        }
        return of(numbers(node), 0);
    }

    /** Translation, rotation and scale of a node, one after the other; those of the identity if it has a matrix. */
    static double[] numbers(GltfPlace node) {
        double[] numbers = new double[GltfSkeleton.SCALE + 3];
        System.arraycopy(node.at("translation").numbersOr(0, 0, 0), 0, numbers, 0, GltfSkeleton.ROTATION);
        System.arraycopy(node.at("rotation").numbersOr(0, 0, 0, 1), 0, numbers, GltfSkeleton.ROTATION, 4);
        System.arraycopy(node.at("scale").numbersOr(1, 1, 1), 0, numbers, GltfSkeleton.SCALE, 3);
        return numbers;
    }

    /** The transform of such numbers, from a place on. */
    static Affine of(double[] numbers, int at) {
        int rotation = at + GltfSkeleton.ROTATION;
        int scale = at + GltfSkeleton.SCALE;
        return of(
                Arrays.copyOfRange(numbers, at, rotation),
                Arrays.copyOfRange(numbers, rotation, scale),
                Arrays.copyOfRange(numbers, scale, scale + 3));
    }

    /** The transform that scales, then rotates by a quaternion, then translates. */
    static Affine of(double[] translation, double[] quaternion, double[] scale) {
        Affine turn = rotation(quaternion);
        return new Affine(
                turn.axisX().times(scale[0]),
                turn.axisY().times(scale[1]),
                turn.axisZ().times(scale[2]),
                column(translation, 0));
    }

    /** The same transform in Twister's axes. */
    static Affine turned(Affine placement) {
        return new Affine(
                Axes.Y_UP.turned(placement.axisX()),
                Axes.Y_UP.turned(placement.axisY()),
                Axes.Y_UP.turned(placement.axisZ()).times(-1),
                Axes.Y_UP.turned(placement.origin()));
    }

    /** Whether the transform preserves volume other than 0 and stays within the range of coordinates. */
    static boolean isUsable(Affine placement) {
        double volume = placement.axisX().dot(placement.axisY().cross(placement.axisZ()));
        double lengths = placement.axisX().length()
                * placement.axisY().length()
                * placement.axisZ().length();
        return Math.abs(volume) > FLAT * lengths && isNear(placement);
    }

    /** Whether the transform stays within the range of coordinates. */
    static boolean isNear(Affine placement) {
        return MeshLimits.isCoordinate(placement.axisX().length())
                && MeshLimits.isCoordinate(placement.axisY().length())
                && MeshLimits.isCoordinate(placement.axisZ().length())
                && MeshLimits.isCoordinate(placement.origin().length());
    }

    private static Vector3 column(double[] numbers, int at) {
        return new Vector3(numbers[at], numbers[at + 1], numbers[at + 2]);
    }

    /** The rotation of a quaternion (x, y, z, w) of any length; the identity if that is 0. */
    private static Affine rotation(double[] q) {
        double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
        double s = square > 0 ? 2 / square : 0;
        double xx = s * q[0] * q[0];
        double yy = s * q[1] * q[1];
        double zz = s * q[2] * q[2];
        double xy = s * q[0] * q[1];
        double xz = s * q[0] * q[2];
        double yz = s * q[1] * q[2];
        double wx = s * q[3] * q[0];
        double wy = s * q[3] * q[1];
        double wz = s * q[3] * q[2];
        return new Affine(
                new Vector3(1 - yy - zz, xy + wz, xz - wy),
                new Vector3(xy - wz, 1 - xx - zz, yz + wx),
                new Vector3(xz + wy, yz - wx, 1 - xx - yy),
                Vector3.ZERO);
    }
}
