package dev.twister.kernel;

/**
 * The emitters of path tracing: lights, spheres and triangles that emit, suns, and the sky.
 * {@link Layout#EMITTER_STRIDE} describes their table.
 */
public final class Emitter {
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
                int isSun = Illumination.isSun(body, looks);
                if (isSun != 0) {
                    SunEmitter.choose(path, body, first, second, looks);
                }
                if ((isTriangle | isSun) == 0) {
                    SphereEmitter.choose(path, body, first, second, bodies);
                    SpotEmitter.dim(path, body, looks);
                    if ((variant & Variant.MAPS) != 0) {
                        EmissionMap.ofSphere(path, body, frame, bodies, looks, images);
                    }
                }
                if ((variant & Variant.MESHES) != 0) {
                    if (isTriangle != 0) {
                        TriangleEmitter.choose(path, emitter, first, second, frame, bodies, looks, meshes);
                        if ((variant & Variant.MAPS) != 0) {
                            EmissionMap.ofTriangle(
                                    path, emitter, first, second, frame, bodies, looks, meshes, images, variant);
                        }
                    }
                }
            }
            path[Layout.LIGHT_DENSITY] = path[Layout.LIGHT_DENSITY] * path[Layout.CHOICE];
        }
    }

    /**
     * Place in {@code looks} of the emitter that {@link #choose} chooses. Writes its probability to
     * {@link Layout#CHOICE}.
     *
     * @param bounce number of surfaces that the path has left before
     */
    public static int chosen(float[] path, int bounce, float[] frame, float[] looks) {
        float number = Noise.fresh(path, Noise.emitter(bounce), frame);
        int start = (int) frame[Layout.EMITTER_TABLE];
        int emitter = 0;
        if (frame[Layout.LIGHT_TREE] > 0f) {
            emitter = LightTree.choose(path, number, frame, looks);
        } else {
            emitter = LightTree.byPower(path, 0, number, frame, looks);
        }
        return start + Layout.EMITTER_STRIDE * emitter;
    }

    private static int isTriangle(int emitter, float[] looks, int variant) {
        int isTriangle = 0;
        if ((variant & Variant.MESHES) != 0) {
            isTriangle = looks[emitter + Layout.EMITTER_TRIANGLE] >= 0f ? 1 : 0;
        }
        return isTriangle;
    }

    /** One channel of the radiance that the surface at {@link Layout#POINT} emits against the path's ray. */
    public static float emission(float[] path, int body, int channel, float[] looks, int variant) {
        return brightest(path, body, channel, looks, variant) * SpotEmitter.part(path, Layout.DIRECTION, body, looks);
    }

    /** As above, on a spot's axis. */
    private static float brightest(float[] path, int body, int channel, float[] looks, int variant) {
        float emission = looks[Layout.LOOK_STRIDE * body + Layout.LOOK_EMISSION + channel];
        if ((variant & Variant.MAPS) != 0) {
            emission = path[Layout.EMISSION + channel];
        }
        return emission;
    }

    /** 1 if both sides of the body's triangles emit, else 0. */
    static int isTwoSided(int body, float[] looks) {
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
        float emission = brightest(path, body, 0, looks, variant)
                + brightest(path, body, 1, looks, variant)
                + brightest(path, body, 2, looks, variant);
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
                density = TriangleEmitter.density(path, emitter, looks);
            } else {
                density = SphereEmitter.density(path, body, bodies);
            }
            float probability = looks[emitter + Layout.EMITTER_PROBABILITY];
            if (frame[Layout.LIGHT_TREE] > 0f) {
                probability = LightTree.probability(path, (int) looks[emitter + Layout.EMITTER_LEAF], frame, looks);
            }
            density = density * probability;
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
