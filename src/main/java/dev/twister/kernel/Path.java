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
     * @param bodies number of bodies
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     * @param search {@link Hit#ALL} or {@link Hit#WALK}
     * @param firstMesh the first mesh's body, or {@link Layout#NO_MESHES}
     * @param materials {@link Material#PLAIN} or {@link Material#ANY}
     * @param aspect {@link Aspect#FULL}, or the count to accumulate in {@link Layout#COUNT}
     */
    public static void follow(
            float[] path,
            int firstBounce,
            float[] properties,
            float[] places,
            float[] looks,
            float[] hierarchy,
            float[] meshes,
            int bodies,
            float[] sky,
            int[] skyDimensions,
            float[] shadowDisc,
            float[] pixelSamples,
            float[] scratch,
            int search,
            int firstMesh,
            int materials,
            int aspect) {
        int bounce = firstBounce;
        int waiting = 0;
        int goesOn = 1;
        while (goesOn != 0) {
            int body = Hit.find(
                    path, places, looks, hierarchy, meshes, bodies, scratch, search, firstMesh, materials, aspect);
            goesOn = 0;
            if (body >= Layout.PLANE) {
                meet(
                        path,
                        body,
                        properties,
                        places,
                        looks,
                        hierarchy,
                        meshes,
                        sky,
                        skyDimensions,
                        firstMesh,
                        materials);
                float visible = visible(
                        path,
                        body,
                        bounce,
                        properties,
                        places,
                        looks,
                        hierarchy,
                        meshes,
                        bodies,
                        shadowDisc,
                        scratch,
                        firstMesh,
                        materials,
                        aspect);
                waiting = scatter(
                        path, body, bounce, visible, properties, looks, pixelSamples, scratch, waiting, materials);
                goesOn = carriesLight(path);
            }
            if (body < Layout.PLANE) {
                end(path, body, properties, looks, sky, skyDimensions);
            }
            bounce = bounce + 1;
            if (((goesOn == 0 ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                Branch.resume(path, scratch, waiting);
                bounce = Branch.bounce(scratch, waiting);
                waiting = waiting - 1;
                goesOn = 1;
            }
            Aspect.count(path, aspect, Aspect.BOUNCES, goesOn);
        }
    }

    /** Adds the light's own color, or the sky, for a ray that hits no surface. */
    public static void end(
            float[] path, int body, float[] properties, float[] looks, float[] sky, int[] skyDimensions) {
        if (body == Layout.NOTHING) {
            Sky.add(path, sky, skyDimensions, properties);
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
            float[] properties,
            float[] places,
            float[] looks,
            float[] hierarchy,
            float[] meshes,
            float[] sky,
            int[] skyDimensions,
            int firstMesh,
            int materials) {
        Surface.find(path, body, places, hierarchy, meshes, firstMesh);
        Material.find(path, body, looks, properties, sky, skyDimensions, firstMesh, materials);
        if (materials == Material.ANY) {
            Surface.face(path, body, firstMesh);
        }
        Light.aim(path, places);
    }

    /** S at the surface that the ray has hit: {@link Shadow#visible}; 1 if the surface is not shaded. */
    public static float visible(
            float[] path,
            int body,
            int bounce,
            float[] properties,
            float[] places,
            float[] looks,
            float[] hierarchy,
            float[] meshes,
            int bodies,
            float[] shadowDisc,
            float[] scratch,
            int firstMesh,
            int materials,
            int aspect) {
        float visible = 1f;
        if (isShaded(path, bounce, properties, materials) != 0) {
            visible = Shadow.visible(
                    path,
                    body,
                    properties,
                    places,
                    looks,
                    shadowDisc,
                    hierarchy,
                    Layout.root(bodies),
                    meshes,
                    scratch,
                    firstMesh,
                    materials,
                    aspect);
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
            float[] properties,
            float[] looks,
            float[] pixelSamples,
            float[] scratch,
            int waiting,
            int materials) {
        float mirror = mirror(path, bounce, properties);
        float transmission = transmission(path, bounce, properties, materials);
        float lit = Light.lit(properties[Layout.AMBIENT], path[Layout.NORMAL_DOT_LIGHT], visible);
        Scatter.shade(path, visible, mirror, transmission, lit, looks);
        int waitingNow = waiting;
        if (materials == Material.ANY) {
            Facet.find(path, bounce, pixelSamples);
            waitingNow = Branch.split(path, body, bounce, mirror, transmission, lit, scratch, waiting);
        } else {
            Scatter.reflect(path, body, mirror * lit);
        }
        return waitingNow;
    }

    /** 0 for perfectly clear glass, whose color does not depend on shadows, else 1. */
    public static int isShaded(float[] path, int bounce, float[] properties, int materials) {
        return (transmission(path, bounce, properties, materials) < 1f ? 1 : 0)
                | (path[Layout.REFLECTIVITY] > 0f ? 1 : 0);
    }

    /** m of the surface hit, in [0, 1]; 0 at the last bounce. */
    public static float mirror(float[] path, int bounce, float[] properties) {
        return bounce < (int) properties[Layout.BOUNCES] ? path[Layout.REFLECTIVITY] / Layout.MAX_REFLECTIVITY : 0f;
    }

    /** t of the surface hit, in [0, 1]; 0 at the last bounce. */
    public static float transmission(float[] path, int bounce, float[] properties, int materials) {
        float transmission = 0f;
        if (materials == Material.ANY) {
            transmission = bounce < (int) properties[Layout.BOUNCES] ? path[Layout.TRANSMISSION] : 0f;
        }
        return transmission;
    }

    /** 1 if light found by the path's ray reaches the pixel, else 0. */
    public static int carriesLight(float[] path) {
        return path[Layout.THROUGHPUT] + path[Layout.THROUGHPUT + 1] + path[Layout.THROUGHPUT + 2] > 0f ? 1 : 0;
    }
}
