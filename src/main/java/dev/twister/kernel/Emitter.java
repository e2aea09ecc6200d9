package dev.twister.kernel;

/**
 * The emitters of path tracing: lights, spheres and triangles that emit, and the sky. {@link Layout#EMITTER_STRIDE}
 * describes their table.
 */
public final class Emitter {
    /** Directions through a sphere whose cone is narrower are not sampled: rounding would decide whether they hit. */
    private static final float LEAST_CONE = 1e-14f;

    private Emitter() {}

    /**
     * Chooses an emitter, and a direction from {@link Layout#POINT} to a point of it. Writes the direction
     * ({@link Layout#TO_LIGHT}), the distance within which a body blocks it, the radiance that comes from there
     * ({@link Layout#EMITTED}) and the density of the choice per steradian ({@link Layout#LIGHT_DENSITY}), 0 if the
     * choice gives no light.
     *
     * @param path {@link Layout#TRACED_PATH_LENGTH} floats
     * @param bounce number of surfaces that the path has left before
     */
    public static void choose(
            float[] path,
            int bounce,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        path[Layout.LIGHT_DENSITY] = 0f;
        if (frame[Layout.EMITTERS] > 0f) {
            int place = Noise.emitter(bounce);
            float first = Noise.fresh(path, place + 1, frame);
            float second = Noise.fresh(path, place + 2, frame);
            int emitter = chosen(path, bounce, frame, looks);
            int body = (int) looks[emitter + Layout.EMITTER_BODY];
            LightLayers.choose(path, body, frame, looks, variant);
            if (body == Layout.NOTHING) {
                towardSky(path, first, second, frame, images);
            }
            if (body > Layout.NOTHING) {
                int look = Layout.LOOK_STRIDE * body;
                path[Layout.EMITTED] = looks[look + Layout.LOOK_EMISSION];
                path[Layout.EMITTED + 1] = looks[look + Layout.LOOK_EMISSION + 1];
                path[Layout.EMITTED + 2] = looks[look + Layout.LOOK_EMISSION + 2];
                int isTriangle = isTriangle(emitter, looks, variant);
                if (isTriangle == 0) {
                    towardSphere(path, body, first, second, bodies);
                    if ((variant & Variant.MAPS) != 0) {
                        EmissionMap.ofSphere(path, body, frame, bodies, looks, images);
                    }
                }
                if ((variant & Variant.MESHES) != 0) {
                    if (isTriangle != 0) {
                        towardTriangle(path, emitter, first, second, frame, bodies, looks, meshes);
                        if ((variant & Variant.MAPS) != 0) {
                            EmissionMap.ofTriangle(
                                    path, emitter, first, second, frame, bodies, looks, meshes, images, variant);
                        }
                    }
                }
            }
            path[Layout.LIGHT_DENSITY] = path[Layout.LIGHT_DENSITY] * looks[emitter + Layout.EMITTER_PROBABILITY];
        }
    }

    /**
     * Place in {@code looks} of the emitter that {@link #choose} chooses.
     *
     * @param bounce number of surfaces that the path has left before
     */
    public static int chosen(float[] path, int bounce, float[] frame, float[] looks) {
        float number = Noise.fresh(path, Noise.emitter(bounce), frame);
        int start = (int) frame[Layout.EMITTER_TABLE];
        int low = 0;
        int high = (int) frame[Layout.EMITTERS] - 1;
        while (low < high) {
            int middle = (low + high) / 2;
            int above = looks[start + Layout.EMITTER_STRIDE * middle + Layout.EMITTER_END] <= number ? 1 : 0;
            low = above != 0 ? middle + 1 : low;
            high = above != 0 ? high : middle;
        }
        return start + Layout.EMITTER_STRIDE * low;
    }

    private static int isTriangle(int emitter, float[] looks, int variant) {
        int isTriangle = 0;
        if ((variant & Variant.MESHES) != 0) {
            isTriangle = looks[emitter + Layout.EMITTER_TRIANGLE] >= 0f ? 1 : 0;
        }
        return isTriangle;
    }

    /** A direction of the cone that a sphere fills (Shirley, Wang and Zimmerman 1996); none from inside. */
    private static void towardSphere(float[] path, int body, float first, float second, float[] bodies) {
        float x = bodies[Layout.PLACE_STRIDE * body] - path[Layout.POINT];
        float y = bodies[Layout.PLACE_STRIDE * body + 1] - path[Layout.POINT + 1];
        float z = bodies[Layout.PLACE_STRIDE * body + 2] - path[Layout.POINT + 2];
        float radius = bodies[Layout.PLACE_STRIDE * body + Layout.PLACE_SIZE];
        float cone = cone(x * x + y * y + z * z, radius);
        float inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
        float below = first * cone;
        float sine = (float) Math.sqrt(Math.max(below * (2f - below), 0f));
        TangentFrame.write(
                path,
                Layout.TO_LIGHT,
                x * inverse,
                y * inverse,
                z * inverse,
                sine * KernelMath.cosineOfTurns(second),
                sine * KernelMath.sineOfTurns(second),
                1f - below);
        float distance = Intersection.sphere(
                x, y, z, radius, path[Layout.TO_LIGHT], path[Layout.TO_LIGHT + 1], path[Layout.TO_LIGHT + 2]);
        int met = (cone > LEAST_CONE ? 1 : 0) & (distance < Intersection.MISS ? 1 : 0);
        path[Layout.LIGHT_DISTANCE] = distance;
        path[Layout.LIGHT_DENSITY] = met != 0 ? coneDensity(cone) : 0f;
    }

    /** {@code 1 - cos} of the half angle of the cone that a sphere fills; 0 from inside. */
    private static float cone(float distanceSquared, float radius) {
        float sineSquared = radius * radius / Math.max(distanceSquared, 1e-30f);
        return sineSquared < 1f ? sineSquared / (1f + (float) Math.sqrt(1f - sineSquared)) : 0f;
    }

    private static float coneDensity(float cone) {
        return 1f / (2f * KernelMath.PI * cone);
    }

    /** A point of a triangle, uniform in its area. */
    private static void towardTriangle(
            float[] path,
            int emitter,
            float first,
            float second,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes) {
        int instance =
                Instance.at((int) looks[emitter + Layout.EMITTER_INSTANCE], (int) frame[Layout.INSTANCES], bodies);
        int triangle = Instance.triangles(bodies, instance)
                + Layout.TRIANGLE_STRIDE * (int) looks[emitter + Layout.EMITTER_TRIANGLE];
        float b = secondCorner(first, second);
        float c = thirdCorner(first, second);
        float meshX = meshes[triangle]
                + b * (meshes[triangle + 3] - meshes[triangle])
                + c * (meshes[triangle + 6] - meshes[triangle]);
        float meshY = meshes[triangle + 1]
                + b * (meshes[triangle + 4] - meshes[triangle + 1])
                + c * (meshes[triangle + 7] - meshes[triangle + 1]);
        float meshZ = meshes[triangle + 2]
                + b * (meshes[triangle + 5] - meshes[triangle + 2])
                + c * (meshes[triangle + 8] - meshes[triangle + 2]);
        int row = instance + Layout.INSTANCE_TO_WORLD;
        float x = Instance.point(bodies, row, meshX, meshY, meshZ) - path[Layout.POINT];
        float y = Instance.point(bodies, row + 4, meshX, meshY, meshZ) - path[Layout.POINT + 1];
        float z = Instance.point(bodies, row + 8, meshX, meshY, meshZ) - path[Layout.POINT + 2];
        float squared = x * x + y * y + z * z;
        float inverse = KernelMath.inverseRoot(squared);
        path[Layout.TO_LIGHT] = x * inverse;
        path[Layout.TO_LIGHT + 1] = y * inverse;
        path[Layout.TO_LIGHT + 2] = z * inverse;
        MeshSurface.writeFace(path, Layout.EMITTER_FACE, instance, triangle, bodies, meshes);
        float along = path[Layout.TO_LIGHT] * path[Layout.EMITTER_FACE]
                + path[Layout.TO_LIGHT + 1] * path[Layout.EMITTER_FACE + 1]
                + path[Layout.TO_LIGHT + 2] * path[Layout.EMITTER_FACE + 2];
        int body = (int) looks[emitter + Layout.EMITTER_BODY];
        int shines = (along < 0f ? 1 : 0) | isTwoSided(body, looks);
        float spread = Math.abs(along) * looks[emitter + Layout.EMITTER_AREA];
        // Slightly before the triangle, so that it does not block itself.
        path[Layout.LIGHT_DISTANCE] = squared * inverse * (1f - 0x1p-13f);
        path[Layout.LIGHT_DENSITY] = (shines & (spread > 0f ? 1 : 0)) != 0 ? squared / spread : 0f;
    }

    /** The weight of a triangle's second corner at the point that two numbers in [0, 1) choose. */
    static float secondCorner(float first, float second) {
        return (float) Math.sqrt(first) * (1f - second);
    }

    /** That of the third corner. */
    static float thirdCorner(float first, float second) {
        return (float) Math.sqrt(first) * second;
    }

    /** One channel of the radiance that the surface at {@link Layout#POINT} emits. */
    public static float emission(float[] path, int body, int channel, float[] looks, int variant) {
        float emission = looks[Layout.LOOK_STRIDE * body + Layout.LOOK_EMISSION + channel];
        if ((variant & Variant.MAPS) != 0) {
            emission = path[Layout.EMISSION + channel];
        }
        return emission;
    }

    /** 1 if both sides of the body's triangles emit, else 0. */
    private static int isTwoSided(int body, float[] looks) {
        return looks[Layout.LOOK_STRIDE * body + Layout.LOOK_ONE_SIDED] > 0f ? 0 : 1;
    }

    private static void towardSky(float[] path, float first, float second, float[] frame, float[] images) {
        SkyTable.choose(path, first, second, frame, images);
        SkyLookup.write(path, Layout.TO_LIGHT, Layout.EMITTED, frame, images);
        path[Layout.LIGHT_DISTANCE] = Intersection.MISS;
    }

    /**
     * 1 if the side of the body that the path's ray hits emits light, else 0. A sphere emits outward.
     *
     * @param path after {@link Surface#find} and {@link Surface#face}
     */
    public static int shines(float[] path, int body, float[] frame, float[] looks, int variant) {
        float emission = emission(path, body, 0, looks, variant)
                + emission(path, body, 1, looks, variant)
                + emission(path, body, 2, looks, variant);
        int mesh = Surface.isMesh(body, frame, variant);
        float along = mesh != 0 ? Facet.directionDot(path, Layout.FACE) : path[Layout.FROM_INSIDE];
        int seen = (along <= 0f ? 1 : 0) | (mesh & isTwoSided(body, looks));
        return (emission > 0f ? 1 : 0) & seen;
    }

    /**
     * Density per steradian with which {@link #choose} takes the direction of the path's ray from its origin to the
     * body that it hits.
     */
    public static float density(float[] path, int body, float[] frame, float[] bodies, float[] looks, int variant) {
        int look = Layout.LOOK_STRIDE * body;
        int entry = (int) looks[look + Layout.LOOK_EMITTER];
        int emitter = (int) frame[Layout.EMITTER_TABLE] + Layout.EMITTER_STRIDE * (entry - 1);
        float density = 0f;
        if (entry > 0) {
            if (Surface.isMesh(body, frame, variant) != 0) {
                emitter = emitter + Layout.EMITTER_STRIDE * (int) path[Layout.TRIANGLE];
                float spread = Math.abs(Facet.directionDot(path, Layout.FACE)) * looks[emitter + Layout.EMITTER_AREA];
                density = spread > 0f ? path[Layout.DISTANCE] * path[Layout.DISTANCE] / spread : 0f;
            } else {
                float x = bodies[Layout.PLACE_STRIDE * body] - path[Layout.ORIGIN];
                float y = bodies[Layout.PLACE_STRIDE * body + 1] - path[Layout.ORIGIN + 1];
                float z = bodies[Layout.PLACE_STRIDE * body + 2] - path[Layout.ORIGIN + 2];
                float radius = bodies[Layout.PLACE_STRIDE * body + Layout.PLACE_SIZE];
                float cone = cone(x * x + y * y + z * z, radius);
                density = cone > LEAST_CONE ? coneDensity(cone) : 0f;
            }
            density = density * looks[emitter + Layout.EMITTER_PROBABILITY];
        }
        return density;
    }

    /** As above, for a ray that meets no body. */
    public static float skyDensity(float[] path, float[] frame, float[] looks, float[] images) {
        float density = 0f;
        if (frame[Layout.SKY_EMITTER] > 0f) {
            int emitter =
                    (int) frame[Layout.EMITTER_TABLE] + Layout.EMITTER_STRIDE * ((int) frame[Layout.SKY_EMITTER] - 1);
            density = looks[emitter + Layout.EMITTER_PROBABILITY] * SkyTable.density(path, frame, images);
        }
        return density;
    }
}
