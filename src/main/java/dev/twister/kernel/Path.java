package dev.twister.kernel;

/** A path from a given ray to its end. An engine that renders part of a path by other means continues it here. */
public final class Path {
    private Path() {}

    /**
     * Follows the path's ray, and adds the light found to {@link Layout#RADIANCE}. {@link Layout} describes the arrays.
     *
     * @param path {@link Layout#PATH_LENGTH} floats: the ray, the body that it leaves, throughput and radiance so far,
     *     the pixel and its sample
     * @param firstBounce number of surfaces that the path has already left, in [0, bounces]
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     * @param variant bits of {@link Variant} of a full picture or of a count in {@link Layout#COUNT}
     */
    public static void follow(
            float[] path,
            int firstBounce,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int bounce = firstBounce;
        int waiting = 0;
        int goesOn = 1;
        while (goesOn != 0) {
            int body = Hit.find(path, scratch, frame, bodies, looks, meshes, variant);
            goesOn = 0;
            if (body >= Layout.PLANE) {
                meet(path, body, frame, bodies, looks, meshes, images, variant);
                float visible = visible(path, body, bounce, scratch, frame, bodies, looks, meshes, variant);
                waiting = scatter(path, body, bounce, visible, scratch, waiting, frame, looks, variant);
                goesOn = carriesLight(path);
            }
            if (body < Layout.PLANE) {
                end(path, body, frame, looks, images);
            }
            bounce = bounce + 1;
            if (((goesOn == 0 ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                Branch.resume(path, scratch, waiting);
                bounce = Branch.bounce(scratch, waiting);
                waiting = waiting - 1;
                goesOn = 1;
            }
            Aspect.count(path, Aspect.BOUNCES, goesOn, variant);
        }
    }

    /** Adds the light's own color, or the sky, for a ray that hits no surface. */
    public static void end(float[] path, int body, float[] frame, float[] looks, float[] images) {
        if (body == Layout.NOTHING) {
            Sky.add(path, frame, images);
        }
        if (body == Layout.LIGHT) {
            Light.add(path, looks);
        }
    }

    /**
     * Writes hit point, normal and material of the surface that the path's ray hits, and the direction to the light.
     */
    public static void meet(
            float[] path,
            int body,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        Surface.find(path, body, frame, bodies, meshes, variant);
        Material.find(path, body, frame, looks, images, variant);
        if ((variant & Variant.MATERIALS) != 0) {
            Surface.face(path, body, frame, variant);
        }
        Light.aim(path, bodies);
    }

    /** S at the surface that the ray has hit: {@link Shadow#visible}; 1 if the surface is not shaded. */
    public static float visible(
            float[] path,
            int body,
            int bounce,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float visible = 1f;
        if (isShaded(path, bounce, frame, variant) != 0) {
            visible = Shadow.visible(path, body, scratch, frame, bodies, looks, meshes, variant);
        }
        return visible;
    }

    /**
     * Adds the surface's reflected light, and replaces the path's ray by the next one; another ray may be left waiting
     * in the scratch.
     *
     * @param visible S in [0, 1]
     * @param waiting number of waiting rays
     * @return the new number of waiting rays
     */
    public static int scatter(
            float[] path,
            int body,
            int bounce,
            float visible,
            float[] scratch,
            int waiting,
            float[] frame,
            float[] looks,
            int variant) {
        float mirror = mirror(path, bounce, frame);
        float transmission = transmission(path, bounce, frame, variant);
        float lit = Light.lit(frame[Layout.AMBIENT], path[Layout.NORMAL_DOT_LIGHT], visible);
        Scatter.shade(path, visible, mirror, transmission, lit, looks, variant);
        int waitingNow = waiting;
        if ((variant & Variant.MATERIALS) != 0) {
            Scatter.emit(path, body, frame, looks, variant);
            Facet.find(path, bounce, frame);
            waitingNow = Branch.split(path, body, bounce, mirror, transmission, lit, scratch, waiting);
        } else {
            Scatter.reflect(path, body, mirror * lit);
        }
        return waitingNow;
    }

    /** 0 for perfectly clear glass, whose color does not depend on shadows, else 1. */
    public static int isShaded(float[] path, int bounce, float[] frame, int variant) {
        return (transmission(path, bounce, frame, variant) < 1f ? 1 : 0) | (path[Layout.REFLECTIVITY] > 0f ? 1 : 0);
    }

    /** m of the surface hit, in [0, 1]; 0 at the last bounce. */
    public static float mirror(float[] path, int bounce, float[] frame) {
        return bounce < frame[Layout.BOUNCES] ? path[Layout.REFLECTIVITY] / Layout.MAX_REFLECTIVITY : 0f;
    }

    /** t of the surface hit, in [0, 1]; 0 at the last bounce. */
    public static float transmission(float[] path, int bounce, float[] frame, int variant) {
        float transmission = 0f;
        if ((variant & Variant.MATERIALS) != 0) {
            transmission = bounce < frame[Layout.BOUNCES] ? path[Layout.TRANSMISSION] : 0f;
        }
        return transmission;
    }

    /** 1 if light found by the path's ray reaches the pixel, else 0. */
    public static int carriesLight(float[] path) {
        return path[Layout.THROUGHPUT] + path[Layout.THROUGHPUT + 1] + path[Layout.THROUGHPUT + 2] > 0f ? 1 : 0;
    }
}
