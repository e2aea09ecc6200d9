package dev.twister.world;

import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Medium;

/** The transmitting bodies that the camera is in: {@link Medium}. */
final class CameraMedia {
    private CameraMedia() {}

    /**
     * Writes the two smallest ones, of which the smallest is the inner one, to the frame of a kernel; none if no body
     * takes any light.
     *
     * @param frame with the camera's position
     * @param present number of present bodies: the first light, the plane and the spheres
     */
    static void write(float[] frame, Bodies bodies, int present) {
        int inner = Layout.NOTHING;
        int outer = Layout.NOTHING;
        if (!bodies.plain()) {
            for (int body = Layout.FIRST_SPHERE; body < bodies.end(); body++) {
                boolean isSphere = body < present;
                boolean isMesh = bodies.firstMesh() != Layout.NO_MESHES && body >= bodies.firstMesh();
                if ((isSphere || isMesh) && bodies.isMedium(body) && holds(bodies, body, isMesh, frame)) {
                    boolean smallest = isSmaller(bodies, body, inner);
                    outer = smallest ? inner : isSmaller(bodies, body, outer) ? body : outer;
                    inner = smallest ? body : inner;
                }
            }
        }
        frame[Layout.CAMERA_MEDIUM] = inner;
        frame[Layout.CAMERA_OUTER_MEDIUM] = outer;
    }

    private static boolean isSmaller(Bodies bodies, int body, int other) {
        return other == Layout.NOTHING || bodies.size(body) < bodies.size(other);
    }

    /** Whether the camera is in a sphere, or in a mesh's bounding sphere and in the mesh. */
    private static boolean holds(Bodies bodies, int body, boolean isMesh, float[] frame) {
        double squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            double away = bodies.center(body, axis) - frame[Layout.CAMERA_POSITION + axis];
            squared += away * away;
        }
        double size = bodies.size(body);
        return squared < size * size && (!isMesh || winds(bodies, instance(bodies, body), frame));
    }

    private static int instance(Bodies bodies, int body) {
        float[] floats = bodies.floats();
        int number = 0;
        while (floats[Instance.at(number, bodies.instances(), floats) + Layout.INSTANCE_BODY] != body) {
            number++;
        }
        return Instance.at(number, bodies.instances(), floats);
    }

    /**
     * Whether a mesh lies around the camera: the sum of the solid angles of its triangles is that of more than half a
     * sphere (Van Oosterom and Strackee, 1983).
     */
    private static boolean winds(Bodies bodies, int instance, float[] frame) {
        float[] floats = bodies.floats();
        float[] meshes = bodies.meshes();
        double[] camera = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            camera[axis] = Instance.point(
                    floats,
                    instance + Layout.INSTANCE_TO_MESH + 4 * axis,
                    frame[Layout.CAMERA_POSITION],
                    frame[Layout.CAMERA_POSITION + 1],
                    frame[Layout.CAMERA_POSITION + 2]);
        }
        int first = Instance.triangles(floats, instance);
        int end = first + Layout.TRIANGLE_STRIDE * (int) floats[instance + Layout.INSTANCE_TRIANGLES];
        double[] corners = new double[Layout.TRIANGLE_VERTICES];
        double halfAngles = 0;
        for (int triangle = first; triangle < end; triangle += Layout.TRIANGLE_STRIDE) {
            for (int i = 0; i < corners.length; i++) {
                corners[i] = meshes[triangle + i] - camera[i % 3];
            }
            halfAngles += halfSolidAngle(corners);
        }
        return Math.abs(halfAngles) > Math.PI;
    }

    /** Of a triangle seen from the origin. */
    private static double halfSolidAngle(double[] corners) {
        double a = Math.sqrt(dot(corners, 0, 0));
        double b = Math.sqrt(dot(corners, 3, 3));
        double c = Math.sqrt(dot(corners, 6, 6));
        double volume = corners[0] * (corners[4] * corners[8] - corners[5] * corners[7])
                + corners[1] * (corners[5] * corners[6] - corners[3] * corners[8])
                + corners[2] * (corners[3] * corners[7] - corners[4] * corners[6]);
        return Math.atan2(volume, a * b * c + dot(corners, 0, 3) * c + dot(corners, 0, 6) * b + dot(corners, 3, 6) * a);
    }

    private static double dot(double[] corners, int first, int second) {
        return corners[first] * corners[second]
                + corners[first + 1] * corners[second + 1]
                + corners[first + 2] * corners[second + 2];
    }
}
