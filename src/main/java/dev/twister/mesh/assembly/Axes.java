package dev.twister.mesh.assembly;

import dev.twister.scene.Vector3;

/**
 * Conversion from a format's right-handed axes to Twister's: x right, y up, z into the picture. Objects are not
 * mirrored.
 */
public enum Axes {
    /** y up and z toward the viewer: negates z. */
    Y_UP {
        @Override
        public Vector3 turned(Vector3 vector) {
            return new Vector3(vector.x(), vector.y(), 0 - vector.z());
        }

        @Override
        void turn(float[] vectors, int size) {
            for (int z = 2; z < size; z += 3) {
                vectors[z] = 0 - vectors[z];
            }
        }
    },
    /** z up and y away from the viewer: swaps y and z. */
    Z_UP {
        @Override
        public Vector3 turned(Vector3 vector) {
            return new Vector3(vector.x(), vector.z(), vector.y());
        }

        @Override
        void turn(float[] vectors, int size) {
            for (int x = 0; x < size; x += 3) {
                float y = vectors[x + 1];
                vectors[x + 1] = vectors[x + 2];
                vectors[x + 2] = y;
            }
        }
    };

    /** Converts a vector. */
    public abstract Vector3 turned(Vector3 vector);

    /**
     * Converts consecutive vectors (x, y, z). Both conversions reverse the winding of triangles, so the caller must
     * swap two corners.
     */
    abstract void turn(float[] vectors, int size);
}
