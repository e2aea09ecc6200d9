package dev.twister.kernel;

/** Secondary rays of surfaces of any material: Whitted's tree, in which the path is one branch and other rays wait. */
public final class Branch {
    /** A branch from a transmitting body ends if its throughput is smaller. */
    public static final float LEAST_THROUGHPUT = 1f / 1024f;

    private Branch() {}

    /**
     * Replaces the path's ray by the reflected or the refracted one. If both continue, the fainter is followed and the
     * other one waits. If none continues, the throughput becomes 0.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, with {@link Layout#FACET}
     * @param body the body that the ray has hit
     * @param mirror m in [0, 1]
     * @param transmission t in [0, 1]
     * @param lit in [0, 1]
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     */
    static void split(
            float[] path, int body, float mirror, float transmission, float lit, float[] scratch, float[] looks) {
        int waiting = (int) path[Layout.WAITING];
        float facing = Facet.directionDot(path, Layout.NORMAL) > 0f ? -1f : 1f;
        float cosineIn = Math.abs(Facet.directionDot(path, Layout.NORMAL));
        float cosine = Math.min(Math.max(-Facet.directionDot(path, Layout.FACET), 0f), 1f);
        int inside = (int) path[Layout.FROM_INSIDE];
        float ratio = 1f;
        float reflectance = 0f;
        if (transmission > 0f) {
            int leaves = inside & (path[Layout.IS_SHEET] > 0f ? 0 : 1);
            ratio = leaves != 0 ? path[Layout.IOR] : 1f / path[Layout.IOR];
            reflectance = Refraction.reflectance(cosine, ratio);
        }
        float passing = (1f - mirror) * transmission;
        float reflectedX = path[Layout.DIRECTION] + 2f * cosine * path[Layout.FACET];
        float reflectedY = path[Layout.DIRECTION + 1] + 2f * cosine * path[Layout.FACET + 1];
        float reflectedZ = path[Layout.DIRECTION + 2] + 2f * cosine * path[Layout.FACET + 2];
        float cosineReflected = facing * dot(path, Layout.NORMAL, reflectedX, reflectedY, reflectedZ);
        float reflected = weighted(path, mirror * lit + passing * reflectance, cosineIn, cosineReflected);
        float refracted = passing * (1f - reflectance);
        float refractedX = 0f;
        float refractedY = 0f;
        float refractedZ = 0f;
        if (refracted > 0f) {
            // Through a sheet the transmitted ray is the reflected one on the other side.
            int sheet = path[Layout.IS_SHEET] > 0f ? 1 : 0;
            float along = Refraction.along(cosine, ratio);
            float mirrored = -2f * facing * cosineReflected;
            refractedX = sheet != 0
                    ? reflectedX + mirrored * path[Layout.NORMAL]
                    : ratio * path[Layout.DIRECTION] + along * path[Layout.FACET];
            refractedY = sheet != 0
                    ? reflectedY + mirrored * path[Layout.NORMAL + 1]
                    : ratio * path[Layout.DIRECTION + 1] + along * path[Layout.FACET + 1];
            refractedZ = sheet != 0
                    ? reflectedZ + mirrored * path[Layout.NORMAL + 2]
                    : ratio * path[Layout.DIRECTION + 2] + along * path[Layout.FACET + 2];
            refracted = weighted(
                    path, refracted, cosineIn, -facing * dot(path, Layout.NORMAL, refractedX, refractedY, refractedZ));
        }
        float least = transmission > 0f ? LEAST_THROUGHPUT : 0f;
        float strongest = reflected
                * strongest(
                        path,
                        Scatter.tint(path, 0, Variant.MATERIALS),
                        Scatter.tint(path, 1, Variant.MATERIALS),
                        Scatter.tint(path, 2, Variant.MATERIALS));
        float strongestPassed =
                strongest(path, path[Layout.PASSING], path[Layout.PASSING + 1], path[Layout.PASSING + 2]) * refracted;
        strongest = strongest < least ? 0f : strongest;
        strongestPassed = strongestPassed < least ? 0f : strongestPassed;
        // The stack cannot overflow as long as colors are at most 1.
        int room = waiting < Layout.MOST_WAITING_RAYS ? 1 : 0;
        int both = (strongest > 0f ? 1 : 0) & (strongestPassed > 0f ? 1 : 0) & room;
        int fainterPasses = strongestPassed < strongest ? 1 : 0;
        int onlyPasses = strongestPassed > strongest ? 1 : 0;
        int passesFirst = both != 0 ? fainterPasses : onlyPasses;
        int refractedInside = body == Layout.PLANE ? 0 : 1 - inside;
        int first = Layout.SCRATCH_RAYS + Layout.RAY_STRIDE * waiting;
        float medium = path[Layout.MEDIUM];
        float outer = path[Layout.OUTER_MEDIUM];
        if (body != Layout.PLANE) {
            Medium.cross(path, body, refractedInside, looks);
        }
        if (both != 0) {
            int passes = 1 - passesFirst;
            scratch[first + Layout.RAY_MEDIUM] = passes != 0 ? path[Layout.MEDIUM] : medium;
            scratch[first + Layout.RAY_OUTER_MEDIUM] = passes != 0 ? path[Layout.OUTER_MEDIUM] : outer;
            start(
                    scratch,
                    first,
                    path,
                    body,
                    passes != 0 ? refractedInside : inside,
                    passes != 0 ? refractedX : reflectedX,
                    passes != 0 ? refractedY : reflectedY,
                    passes != 0 ? refractedZ : reflectedZ,
                    passes,
                    passes != 0 ? refracted : reflected);
        }
        float none = strongest > 0f ? reflected : 0f;
        start(
                path,
                0,
                path,
                body,
                passesFirst != 0 ? refractedInside : inside,
                passesFirst != 0 ? refractedX : reflectedX,
                passesFirst != 0 ? refractedY : reflectedY,
                passesFirst != 0 ? refractedZ : reflectedZ,
                passesFirst,
                passesFirst != 0 ? refracted : none);
        path[Layout.MEDIUM] = passesFirst != 0 ? path[Layout.MEDIUM] : medium;
        path[Layout.OUTER_MEDIUM] = passesFirst != 0 ? path[Layout.OUTER_MEDIUM] : outer;
        path[Layout.WAITING] = waiting + both;
    }

    /** Continues with the newest waiting ray. */
    static void resume(float[] path, float[] scratch) {
        int waiting = (int) path[Layout.WAITING] - 1;
        int first = Layout.SCRATCH_RAYS + Layout.RAY_STRIDE * waiting;
        for (int i = 0; i < Layout.RAY_LENGTH; i++) {
            path[i] = scratch[first + i];
        }
        path[Layout.MEDIUM] = scratch[first + Layout.RAY_MEDIUM];
        path[Layout.OUTER_MEDIUM] = scratch[first + Layout.RAY_OUTER_MEDIUM];
        path[Layout.WAITING] = waiting;
    }

    /**
     * Starts a ray at the path's hit point, in the first floats of an array with the path's layout.
     *
     * @param passes 1 if the ray is transmitted and takes the body's color, else 0
     * @param part part of the path's throughput
     */
    private static void start(
            float[] ray,
            int first,
            float[] path,
            int body,
            int inside,
            float x,
            float y,
            float z,
            int passes,
            float part) {
        float inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
        ray[first + Layout.DIRECTION] = x * inverse;
        ray[first + Layout.DIRECTION + 1] = y * inverse;
        ray[first + Layout.DIRECTION + 2] = z * inverse;
        for (int i = 0; i < 3; i++) {
            ray[first + Layout.ORIGIN + i] = path[Layout.POINT + i];
            ray[first + Layout.THROUGHPUT + i] = path[Layout.THROUGHPUT + i]
                    * part
                    * (passes != 0 ? path[Layout.PASSING + i] : Scatter.tint(path, i, Variant.MATERIALS));
        }
        ray[first + Layout.LEAVING] = body;
        ray[first + Layout.INSIDE] = passes != 0 ? crossed(inside) : inside;
        ray[first + Layout.LEAVING_TRIANGLE] = path[Layout.LEAVING_TRIANGLE];
        ray[first + Layout.BOUNCE] = path[Layout.BOUNCE];
    }

    /** {@link Layout#INSIDE} of a ray that has crossed a surface. */
    static float crossed(int inside) {
        return inside != 0 ? Layout.CROSSED_INTO : Layout.CROSSED_OUT;
    }

    /** Applies the weight of the facet sample on a rough surface; 0 for directions on the wrong side. */
    private static float weighted(float[] path, float part, float cosineIn, float cosineOut) {
        float weighted = part;
        if (path[Layout.ROUGHNESS] > 0f) {
            weighted = cosineOut > 0f ? part * Facet.weight(path[Layout.ROUGHNESS], cosineIn, cosineOut) : 0f;
        }
        return weighted;
    }

    private static float strongest(float[] path, float red, float green, float blue) {
        return Math.max(
                Math.max(path[Layout.THROUGHPUT] * red, path[Layout.THROUGHPUT + 1] * green),
                path[Layout.THROUGHPUT + 2] * blue);
    }

    private static float dot(float[] path, int vector, float x, float y, float z) {
        return path[vector] * x + path[vector + 1] * y + path[vector + 2] * z;
    }
}
