package dev.twister.kernel;

/**
 * The bodies that a path's ray is inside of, which take a part of its light (Beer's law): that which it has entered
 * last, and the one around that. A third one around both is forgotten. A body counts if its material transmits and is
 * no thin sheet.
 */
public final class Medium {
    /** {@code 1 / e}. */
    private static final float INVERSE_E = 0.36787945f;

    private Medium() {}

    /** A view ray is in the bodies that the camera is in. */
    public static void begin(float[] path, float[] frame, int variant) {
        if ((variant & Variant.MATERIALS) != 0) {
            path[Layout.MEDIUM] = frame[Layout.CAMERA_MEDIUM];
            path[Layout.OUTER_MEDIUM] = frame[Layout.CAMERA_OUTER_MEDIUM];
        }
    }

    /**
     * The path's ray has reached a body: the throughput loses what the medium takes.
     *
     * @param path after {@link Surface#face}
     */
    static void meet(float[] path, int body, float[] looks) {
        int inside = path[Layout.FROM_INSIDE] > 0f ? 1 : 0;
        int known = (body == (int) path[Layout.MEDIUM] ? 1 : 0) | (body == (int) path[Layout.OUTER_MEDIUM] ? 1 : 0);
        // Such as the glass on a table: at the bottom, light of the table does not pass the glass's surface.
        if ((inside & (1 - known)) != 0) {
            enter(path, body, looks);
        }
        // A body in one place with the one just entered: light that it scatters does not pass that one's surface.
        int coated = (path[Layout.DISTANCE] <= Triangle.TOUCHING ? 1 : 0)
                & (path[Layout.INSIDE] > 1f ? 1 : 0)
                & (path[Layout.TRANSMISSION] > 0f ? 0 : 1);
        if (coated != 0) {
            leave(path, (int) path[Layout.LEAVING]);
        }
        absorb(path, looks);
    }

    /** Multiplies the throughput by {@code exp(-absorption * distance)} over the path's ray. */
    static void absorb(float[] path, float[] looks) {
        if (path[Layout.MEDIUM] > Layout.NOTHING) {
            float distance = path[Layout.DISTANCE];
            path[Layout.THROUGHPUT] = path[Layout.THROUGHPUT] * passed(path, 0, distance, looks);
            path[Layout.THROUGHPUT + 1] = path[Layout.THROUGHPUT + 1] * passed(path, 1, distance, looks);
            path[Layout.THROUGHPUT + 2] = path[Layout.THROUGHPUT + 2] * passed(path, 2, distance, looks);
        }
    }

    /**
     * The part of one channel's light that passes the medium; all of it on the way to the sky, which no closed body
     * holds.
     *
     * @param distance in meters
     */
    private static float passed(float[] path, int channel, float distance, float[] looks) {
        float passed = 1f;
        if (((path[Layout.MEDIUM] > Layout.NOTHING ? 1 : 0) & (distance < Intersection.MISS ? 1 : 0)) != 0) {
            float absorption = looks[Layout.LOOK_STRIDE * (int) path[Layout.MEDIUM] + Layout.LOOK_ABSORPTION + channel];
            passed = KernelMath.pow(INVERSE_E, Math.min(absorption * distance, KernelMath.MOST_EXPONENT));
        }
        return passed;
    }

    /**
     * The part of radiance in the medium that reaches the outside, {@code 1 / n^2}: rays spread where they leave it.
     * The camera is outside, also where it is within a body.
     */
    static float spread(float[] path, float[] looks) {
        float index = index((int) path[Layout.MEDIUM], looks) * index((int) path[Layout.OUTER_MEDIUM], looks);
        return 1f / (index * index);
    }

    private static float index(int body, float[] looks) {
        return body > Layout.NOTHING ? Math.max(looks[Layout.LOOK_STRIDE * body + Layout.LOOK_IOR], 1f) : 1f;
    }

    /**
     * Multiplies {@link Layout#SCATTERED} by what is left of an emitter's light at the surface that the path has met,
     * and outside.
     *
     * @param path with the direction in {@link Layout#TO_LIGHT}
     * @param crosses 1 if the way to the emitter is on the surface's other side, else 0
     */
    public static void dim(float[] path, int body, int crosses, float[] looks) {
        float medium = path[Layout.MEDIUM];
        float outer = path[Layout.OUTER_MEDIUM];
        if (crosses != 0) {
            cross(path, body, path[Layout.FROM_INSIDE] > 0f ? 0 : 1, looks);
        }
        float distance = path[Layout.LIGHT_DISTANCE];
        float spread = distance < Intersection.MISS ? spread(path, looks) : 1f;
        path[Layout.SCATTERED] = path[Layout.SCATTERED] * passed(path, 0, distance, looks) * spread;
        path[Layout.SCATTERED + 1] = path[Layout.SCATTERED + 1] * passed(path, 1, distance, looks) * spread;
        path[Layout.SCATTERED + 2] = path[Layout.SCATTERED + 2] * passed(path, 2, distance, looks) * spread;
        path[Layout.MEDIUM] = medium;
        path[Layout.OUTER_MEDIUM] = outer;
    }

    /**
     * The path's next ray passes a body's surface.
     *
     * @param into 1 if it enters the body, 0 if it leaves it
     */
    static void cross(float[] path, int body, int into, float[] looks) {
        if (into != 0) {
            enter(path, body, looks);
        } else {
            leave(path, body);
        }
    }

    private static void enter(float[] path, int body, float[] looks) {
        int counts = (looks[Layout.LOOK_STRIDE * body + Layout.LOOK_TRANSMISSION] > 0f ? 1 : 0)
                & (looks[Layout.LOOK_STRIDE * body + Layout.LOOK_SHEET] > 0f ? 0 : 1)
                & (body == (int) path[Layout.MEDIUM] ? 0 : 1);
        path[Layout.OUTER_MEDIUM] = counts != 0 ? path[Layout.MEDIUM] : path[Layout.OUTER_MEDIUM];
        path[Layout.MEDIUM] = counts != 0 ? body : path[Layout.MEDIUM];
    }

    private static void leave(float[] path, int body) {
        int first = body == (int) path[Layout.MEDIUM] ? 1 : 0;
        int left = first | (body == (int) path[Layout.OUTER_MEDIUM] ? 1 : 0);
        path[Layout.MEDIUM] = first != 0 ? path[Layout.OUTER_MEDIUM] : path[Layout.MEDIUM];
        path[Layout.OUTER_MEDIUM] = left != 0 ? Layout.NOTHING : path[Layout.OUTER_MEDIUM];
    }
}
