package dev.twister.kernel;

/** A path of rays from one that is given to its end. Whoever draws a part of a path by other means may take it up here. */
public final class Path {
    private Path() {}

    /**
     * Follows the path's ray, and adds what it finds to {@link Layout#RADIANCE}. The arrays are {@link Layout}'s.
     *
     * @param path {@link Layout#PATH_LENGTH} floats: the ray, the body that it leaves, the throughput and the radiance
     *     so far, the pixel and its sample
     * @param firstBounce how many surfaces the path has left already, in [0, bounces]
     * @param bodies how many there are
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     * @param search {@link Hit#ALL} or {@link Hit#WALK}
     * @param firstMesh the first mesh's body, or {@link Layout#NO_MESHES}
     * @param materials {@link Material#PLAIN} or {@link Material#ANY}
     * @param aspect {@link Aspect#FULL}, or what is counted in {@link Layout#COUNT} beside
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
        int bounces = (int) properties[Layout.BOUNCES];
        int bounce = firstBounce;
        int waiting = 0;
        int goesOn = 1;
        while (goesOn != 0) {
            int body = Hit.find(
                    path, places, looks, hierarchy, meshes, bodies, scratch, search, firstMesh, materials, aspect);
            if (body == Layout.NOTHING) {
                Sky.add(path, sky, skyDimensions, properties);
            }
            if (body == Layout.LIGHT) {
                Light.add(path, looks);
            }
            goesOn = 0;
            if (body >= Layout.PLANE) {
                Surface.find(path, body, places, hierarchy, meshes, firstMesh);
                Material.find(path, body, looks, properties, sky, skyDimensions, firstMesh, materials);
                float mirror = bounce < bounces ? path[Layout.REFLECTIVITY] / Layout.MAX_REFLECTIVITY : 0f;
                float transmission = 0f;
                int shaded = 1;
                if (materials == Material.ANY) {
                    Surface.face(path, body, firstMesh);
                    transmission = bounce < bounces ? path[Layout.TRANSMISSION] : 0f;
                    // Clear glass shows no light of its own.
                    shaded = (transmission < 1f ? 1 : 0) | (path[Layout.REFLECTIVITY] > 0f ? 1 : 0);
                }
                Light.aim(path, places);
                float visible = 1f;
                if (shaded != 0) {
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
                float lit = Light.lit(properties[Layout.AMBIENT], path[Layout.NORMAL_DOT_LIGHT], visible);
                Scatter.shade(path, visible, mirror, transmission, lit, looks);
                if (materials == Material.ANY) {
                    Facet.find(path, bounce, pixelSamples);
                    waiting = Branch.split(path, body, bounce, mirror, transmission, lit, scratch, waiting);
                } else {
                    Scatter.reflect(path, body, mirror * lit);
                }
                goesOn = path[Layout.THROUGHPUT] + path[Layout.THROUGHPUT + 1] + path[Layout.THROUGHPUT + 2] > 0f
                        ? 1
                        : 0;
            }
            bounce = bounce + 1;
            if (((goesOn == 0 ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                Branch.resume(path, scratch, waiting);
                bounce = (int) scratch[Layout.SCRATCH_RAYS + Layout.RAY_STRIDE * (waiting - 1) + Layout.RAY_BOUNCE];
                waiting = waiting - 1;
                goesOn = 1;
            }
            Aspect.count(path, aspect, Aspect.BOUNCES, goesOn);
        }
    }
}
