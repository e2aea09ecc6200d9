package dev.twister.mesh;

/**
 * How a format's right-handed axes become Twister's: x right, y up, z into the picture. Neither mirrors what is seen.
 */
enum Axes {
    /** y up and z to the viewer: z changes its sign. */
    Y_UP {
        @Override
        void turn(float[] vectors, int size) {
            for (int z = 2; z < size; z += 3) {
                vectors[z] = 0 - vectors[z];
            }
        }
    },
    /** z up and y away from the viewer: y and z change places. */
    Z_UP {
        @Override
        void turn(float[] vectors, int size) {
            for (int x = 0; x < size; x += 3) {
                float y = vectors[x + 1];
                vectors[x + 1] = vectors[x + 2];
                vectors[x + 2] = y;
            }
        }
    };

    /** Turns (x, y, z) after (x, y, z). Both ways turn triangles inside out, so two corners change places with it. */
    abstract void turn(float[] vectors, int size);
}
