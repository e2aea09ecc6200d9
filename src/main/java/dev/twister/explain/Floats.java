package dev.twister.explain;

import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;

/** Three floats of an array as what they mean. */
final class Floats {
    private Floats() {}

    static Rgb rgb(float[] array, int at) {
        return new Rgb(array[at], array[at + 1], array[at + 2]);
    }

    static Vector3 vector(float[] array, int at) {
        return new Vector3(array[at], array[at + 1], array[at + 2]);
    }

    /** A place that is seen from the origin, in the scene's own coordinates. */
    static Vector3 place(float[] array, int at, Vector3 origin) {
        return vector(array, at).plus(origin);
    }
}
