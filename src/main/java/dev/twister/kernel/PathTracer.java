package dev.twister.kernel;

/**
 * Path tracing: one path per sample, which follows one scattered ray from each surface and adds the light that reaches
 * it directly from one emitter (Kajiya, "The Rendering Equation", 1986). Light found in both ways is weighted by the
 * power heuristic (Veach and Guibas 1995).
 */
public final class PathTracer {
    /** Number of surfaces from which on paths end at random. */
    public static final int FIRST_ROULETTE = 3;

    private static final float MOST_SURVIVAL = 0.95f;

    /**
     * Survival per throughput. If it were 1, every path that goes on would carry as much as at its start, and the few
     * that find light late, such as a caustic seen from a white wall, would be bright grains.
     */
    private static final float SURVIVAL = 2f;

    /** What a ray is: none, one of the path, or one to an emitter. */
    public static final int NO_RAY = 0;

    public static final int TO_SURFACE = 1;
    public static final int TO_EMITTER = 2;

    private PathTracer() {}

    /**
     * Follows the path's ray, and adds the radiance found to {@link Layout#RADIANCE}.
     *
     * @param path {@link Layout#TRACED_PATH_LENGTH} floats: the ray, the body that it leaves, throughput and radiance
     *     so far, the pixel and its sample
     */
    static void follow(
            float[] path,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        begin(path, frame, variant);
        int bounce = 0;
        int ray = TO_SURFACE;
        while (ray != NO_RAY) {
            int meets = ray == TO_SURFACE ? 1 : 0;
            ray = step(path, bounce, ray, scratch, frame, bodies, looks, meshes, images, variant);
            bounce = bounce + meets;
        }
    }

    /** Starts a sample's path, of which {@link #find} and {@link #arrive} follow the view ray. */
    public static void start(float[] path, int column, int row, int sample, float[] frame, int variant) {
        PixelKernel.start(path, column, row, sample, frame);
        Guides.begin(path, variant);
        begin(path, frame, variant);
    }

    /** Prepares for the first {@link #step} from a view ray. */
    public static void begin(float[] path, float[] frame, int variant) {
        Medium.begin(path, frame, variant);
        path[Layout.SURFACE_DENSITY] = 0f;
        path[Layout.RAYS] = 0f;
    }

    /**
     * Follows one ray, and replaces it by the next one. Rays to emitters take turns with the rays of the path, so that
     * there is one search for hits.
     *
     * @param bounce number of surfaces that the path has left before this ray; a ray to an emitter does not count
     * @param ray {@link #TO_SURFACE}, or {@link #TO_EMITTER} with the light to add in {@link Layout#DIRECT}
     * @return what the next ray is: one of these, or {@link #NO_RAY}
     */
    public static int step(
            float[] path,
            int bounce,
            int ray,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int direct = ray == TO_EMITTER ? 1 : 0;
        int body = find(path, ray, scratch, frame, bodies, looks, meshes, variant);
        int next = NO_RAY;
        if (direct != 0) {
            next = light(path, body, scratch, variant);
        }
        if (direct == 0) {
            next = arrive(path, body, bounce, scratch, frame, bodies, looks, meshes, images, variant);
        }
        return next;
    }

    /**
     * Finds what the path's ray meets.
     *
     * @param ray as {@link #step} takes it
     * @return the closest body, or for a ray to an emitter any that blocks it; {@link Layout#NOTHING} for none
     */
    public static int find(
            float[] path,
            int ray,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float limit = ray == TO_EMITTER ? path[Layout.LIGHT_DISTANCE] : Intersection.MISS;
        int body = Hit.within(path, limit, scratch, frame, bodies, looks, meshes, variant);
        if ((variant & Variant.MASKS) != 0) {
            path[Layout.RAYS] = path[Layout.RAYS] + 1f;
        }
        return body;
    }

    /**
     * Ends a ray to an emitter, and replaces it by the next ray.
     *
     * @param body the body that blocks it, or {@link Layout#NOTHING}
     * @return as {@link #step} returns it
     */
    public static int light(float[] path, int body, float[] scratch, int variant) {
        addDirect(path, body, scratch, variant);
        next(path);
        return carriesLight(path) != 0 ? TO_SURFACE : NO_RAY;
    }

    /**
     * Ends a ray of the path at its closest hit, and replaces it by the next ray.
     *
     * @param body the body hit, or {@link Layout#NOTHING}
     * @param bounce as {@link #step} takes it
     * @return as {@link #step} returns it
     */
    public static int arrive(
            float[] path,
            int body,
            int bounce,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int toEmitter = 0;
        int background = body == Layout.NOTHING ? Coverage.traces(bounce, variant) : 0;
        if (background != 0) {
            Coverage.add(path);
        }
        if (((body == Layout.NOTHING ? 1 : 0) & (1 - background)) != 0) {
            addSuns(path, bounce, scratch, frame, looks, variant);
            addSky(path, bounce, scratch, frame, looks, images, variant);
        }
        if (body > Layout.NOTHING) {
            meet(path, body, frame, bodies, looks, meshes, images, variant);
            addEmission(path, body, bounce, scratch, frame, bodies, looks, variant);
        }
        int isSurface = (body > Layout.LIGHT ? 1 : 0) & (1 - Surface.isLight(body, looks, variant));
        if (isSurface != 0) {
            if (bounce <= (int) frame[Layout.BOUNCES]) {
                toEmitter = scatter(path, body, bounce, frame, bodies, looks, meshes, images, variant);
            } else {
                end(path);
            }
            Guides.trace(path, variant);
        }
        int goesOn = isSurface != 0 ? carriesLight(path) : 0;
        Views.count(path, Views.BOUNCES, goesOn, variant);
        if (toEmitter == 0) {
            next(path);
        }
        int onward = goesOn != 0 ? TO_SURFACE : NO_RAY;
        return toEmitter != 0 ? TO_EMITTER : onward;
    }

    /** Writes hit point, normal and material, and applies the medium that the ray has passed. */
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
        SurfaceLook.find(path, body, frame, looks, images, variant);
        if ((variant & Variant.MAPS) != 0) {
            SurfaceMaps.find(path, body, frame, bodies, looks, meshes, images, variant);
        }
        Surface.face(path, body, frame, variant);
        if ((variant & Variant.FINISH) != 0) {
            FinishMaps.find(path, body, frame, bodies, looks, meshes, images, variant);
        }
        if ((variant & Variant.MAPS) != 0) {
            NormalMap.apply(path, body, frame, bodies, looks, meshes, images, variant);
        }
        if ((variant & Variant.FINISH) != 0) {
            FinishMaps.straighten(path);
        }
        Medium.meet(path, body, looks);
    }

    /** The power heuristic for a direction that could have been chosen in another way, too. */
    public static float weight(float density, float other) {
        float ratio = other / density;
        return 1f / (1f + ratio * ratio);
    }

    private static void addSky(
            float[] path, int bounce, float[] scratch, float[] frame, float[] looks, float[] images, int variant) {
        float weight = 1f;
        if (path[Layout.SURFACE_DENSITY] > 0f) {
            weight = weight(path[Layout.SURFACE_DENSITY], Emitter.skyDensity(path, frame, looks, images));
        }
        SkyLookup.write(path, Layout.DIRECTION, Layout.EMITTED, frame, images);
        weight = clamped(path, weight, bounce, frame);
        add(path, weight);
        LightLayers.add(path, scratch, Layout.NOTHING, weight, frame, looks, variant);
        Guides.shine(path, path[Layout.EMITTED], path[Layout.EMITTED + 1], path[Layout.EMITTED + 2], variant);
    }

    /** Adds the light of the suns before the sky. */
    private static void addSuns(float[] path, int bounce, float[] scratch, float[] frame, float[] looks, int variant) {
        int first = SunEmitter.first(frame);
        int count = (int) frame[Layout.SUNS];
        for (int sun = 0; sun < count; sun++) {
            int emitter = first + Layout.EMITTER_STRIDE * sun;
            int body = (int) looks[emitter + Layout.EMITTER_BODY];
            if (SunEmitter.isMet(path, body, looks) != 0) {
                float weight = 1f;
                if (path[Layout.SURFACE_DENSITY] > 0f) {
                    weight = weight(path[Layout.SURFACE_DENSITY], SunEmitter.density(emitter, looks));
                }
                int emission = Layout.LOOK_STRIDE * body + Layout.LOOK_EMISSION;
                path[Layout.EMITTED] = looks[emission];
                path[Layout.EMITTED + 1] = looks[emission + 1];
                path[Layout.EMITTED + 2] = looks[emission + 2];
                weight = clamped(path, weight, bounce, frame);
                add(path, weight);
                LightLayers.add(path, scratch, body, weight, frame, looks, variant);
                Guides.shine(path, path[Layout.EMITTED], path[Layout.EMITTED + 1], path[Layout.EMITTED + 2], variant);
            }
        }
    }

    private static void addEmission(
            float[] path,
            int body,
            int bounce,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            int variant) {
        if (Emitter.shines(path, body, frame, looks, variant) != 0) {
            float weight = 1f;
            if (path[Layout.SURFACE_DENSITY] > 0f) {
                weight = weight(
                        path[Layout.SURFACE_DENSITY], Emitter.density(path, body, frame, bodies, looks, variant));
            }
            emit(path, body, looks, variant);
            weight = clamped(path, weight, bounce, frame);
            add(path, weight);
            LightLayers.add(path, scratch, body, weight, frame, looks, variant);
            Guides.shine(path, path[Layout.EMITTED], path[Layout.EMITTED + 1], path[Layout.EMITTED + 2], variant);
        }
    }

    /** Writes the radiance of the emitter that the path has met, as it is outside of the path's medium. */
    public static void emit(float[] path, int body, float[] looks, int variant) {
        float spread = Medium.spread(path, looks);
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.EMITTED + channel] = Emitter.emission(path, body, channel, looks, variant) * spread;
        }
    }

    /** Adds emitted radiance times the throughput. */
    private static void add(float[] path, float weight) {
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.RADIANCE + channel] = path[Layout.RADIANCE + channel]
                    + path[Layout.THROUGHPUT + channel] * weight * path[Layout.EMITTED + channel];
        }
    }

    /** The weight of the light that the path has met, less what the clamp takes. */
    private static float clamped(float[] path, float weight, int bounce, float[] frame) {
        float most = bounce > 1 ? frame[Layout.CLAMP] : 0f;
        float luminance = luminance(
                path[Layout.THROUGHPUT] * path[Layout.EMITTED],
                path[Layout.THROUGHPUT + 1] * path[Layout.EMITTED + 1],
                path[Layout.THROUGHPUT + 2] * path[Layout.EMITTED + 2]);
        return weight * kept(weight * luminance, most);
    }

    /**
     * Factor of light for the clamp, which limits its luminance and leaves its hue.
     *
     * @param most limit of the luminance; 0 for none
     */
    private static float kept(float luminance, float most) {
        int clamps = (most > 0f ? 1 : 0) & (luminance > most ? 1 : 0);
        return clamps != 0 ? most / luminance : 1f;
    }

    /** Luminance of linear sRGB (ITU-R BT.709). */
    private static float luminance(float red, float green, float blue) {
        return 0.2126f * red + 0.7152f * green + 0.0722f * blue;
    }

    /**
     * Chooses an emitter and the next ray at the surface that the path has hit. The throughput becomes that of the next
     * ray.
     *
     * @return 1 if the path's ray now leads to an emitter, with the light to add in {@link Layout#DIRECT}, else 0
     */
    private static int scatter(
            float[] path,
            int body,
            int bounce,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        Lobes.prepare(path, body, bounce, frame, looks, variant);
        int toEmitter = 0;
        if (Lobes.scatters(path, variant) != 0) {
            Emitter.choose(path, bounce, frame, bodies, looks, meshes, images, variant);
            if (path[Layout.LIGHT_DENSITY] > 0f) {
                toEmitter = direct(path, body, bounce, frame, looks, variant);
            }
        }
        Lobes.choose(path, bounce, frame, looks, variant);
        if (path[Layout.NEXT_INSIDE] != path[Layout.FROM_INSIDE]) {
            Medium.cross(path, body, path[Layout.NEXT_INSIDE] > 0f ? 1 : 0, looks);
        }
        if (bounce >= FIRST_ROULETTE) {
            roulette(path, bounce, frame);
        }
        if (endsAt(path, bounce, frame) != 0) {
            end(path);
        }
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.ORIGIN + axis] = path[Layout.POINT + axis];
        }
        path[Layout.LEAVING] = body;
        if (toEmitter != 0) {
            float inside = path[Layout.FROM_INSIDE];
            path[Layout.INSIDE] = crossesToLight(path) != 0 ? Branch.crossed(inside > 0f ? 0 : 1) : inside;
            for (int axis = 0; axis < 3; axis++) {
                path[Layout.DIRECTION + axis] = path[Layout.TO_LIGHT + axis];
            }
        }
        return toEmitter;
    }

    /**
     * 1 if the path ends at the surface that it has met, after {@link Lobes#choose}: at the last one, whose light has
     * been taken from an emitter, unless its direction is mirror-like. Such a ray may still meet an emitter or the sky.
     */
    public static int endsAt(float[] path, int bounce, float[] frame) {
        return (bounce < (int) frame[Layout.BOUNCES] ? 0 : 1) & (path[Layout.SURFACE_DENSITY] > 0f ? 1 : 0);
    }

    private static void end(float[] path) {
        path[Layout.THROUGHPUT] = 0f;
        path[Layout.THROUGHPUT + 1] = 0f;
        path[Layout.THROUGHPUT + 2] = 0f;
    }

    /**
     * Writes {@code f * |cos|} of the direction to the chosen emitter, times what the medium leaves of its light, to
     * {@link Layout#SCATTERED}; returns the density of {@link Lobes#evaluate}.
     */
    public static float evaluateToLight(float[] path, int body, float[] looks, int variant) {
        float density = Lobes.evaluate(
                path, path[Layout.TO_LIGHT], path[Layout.TO_LIGHT + 1], path[Layout.TO_LIGHT + 2], looks, variant);
        Medium.dim(path, body, crossesToLight(path), looks);
        return density;
    }

    /** 1 if the chosen emitter is on the other side of the surface of a body that has an inside, else 0. */
    private static int crossesToLight(float[] path) {
        float side = path[Layout.TO_LIGHT] * path[Layout.NORMAL]
                + path[Layout.TO_LIGHT + 1] * path[Layout.NORMAL + 1]
                + path[Layout.TO_LIGHT + 2] * path[Layout.NORMAL + 2];
        return (side < 0f ? 1 : 0) & (path[Layout.IS_SHEET] > Layout.SHEET_OF_BODY ? 0 : 1);
    }

    /** Writes the light that the chosen emitter adds unless it is blocked; 1 if that is any. */
    private static int direct(float[] path, int body, int bounce, float[] frame, float[] looks, int variant) {
        float density = evaluateToLight(path, body, looks, variant);
        float chosen = path[Layout.LIGHT_DENSITY];
        // After the last bounce no ray is scattered that could meet the emitter, too.
        int last = bounce < (int) frame[Layout.BOUNCES] ? 0 : 1;
        float weight = (last != 0 ? 1f : weight(chosen, density)) / chosen;
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.DIRECT + channel] = path[Layout.THROUGHPUT + channel]
                    * weight
                    * path[Layout.SCATTERED + channel]
                    * path[Layout.EMITTED + channel];
        }
        float found = luminance(path[Layout.DIRECT], path[Layout.DIRECT + 1], path[Layout.DIRECT + 2]);
        float kept = kept(found, bounce > 0 ? frame[Layout.CLAMP] : 0f);
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.DIRECT + channel] = path[Layout.DIRECT + channel] * kept;
        }
        return found > 0f ? 1 : 0;
    }

    /** Adds the emitter's light unless a body blocks it. */
    private static void addDirect(float[] path, int body, float[] scratch, int variant) {
        float visible = body == Layout.NOTHING ? 1f : 0f;
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.RADIANCE + channel] = path[Layout.RADIANCE + channel] + visible * path[Layout.DIRECT + channel];
        }
        LightLayers.addDirect(path, scratch, visible, variant);
    }

    /** Ends the path at random, more probably the less light it carries. */
    private static void roulette(float[] path, int bounce, float[] frame) {
        float survival = survival(path);
        int ends = Noise.fresh(path, Noise.roulette(bounce), frame) >= survival ? 1 : 0;
        float factor = ends != 0 ? 0f : 1f / survival;
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.THROUGHPUT + channel] = path[Layout.THROUGHPUT + channel] * factor;
        }
    }

    /** Probability with which a path goes on, from surface {@link #FIRST_ROULETTE} on. */
    public static float survival(float[] path) {
        float most =
                Math.max(Math.max(path[Layout.THROUGHPUT], path[Layout.THROUGHPUT + 1]), path[Layout.THROUGHPUT + 2]);
        return Math.min(SURVIVAL * most, MOST_SURVIVAL);
    }

    /** 1 if light found from here on reaches the pixel, else 0. */
    private static int carriesLight(float[] path) {
        return path[Layout.THROUGHPUT] + path[Layout.THROUGHPUT + 1] + path[Layout.THROUGHPUT + 2] > 0f ? 1 : 0;
    }

    /** Replaces the path's ray by the next one. */
    private static void next(float[] path) {
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.DIRECTION + axis] = path[Layout.NEXT_DIRECTION + axis];
        }
        path[Layout.INSIDE] = path[Layout.NEXT_INSIDE];
    }
}
