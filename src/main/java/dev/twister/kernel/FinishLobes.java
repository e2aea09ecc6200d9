package dev.twister.kernel;

/**
 * What the finish of a surface changes in {@link Lobes}, as the extensions of glTF's material define it: a clear coat
 * and a sheen on top, which take what they reflect from the rest; the color of the specular reflection, a thin film and
 * anisotropy of the reflection below; light that passes a matte surface; dispersion.
 */
final class FinishLobes {
    /** Half the difference of the indices of blue and red per dispersion and {@code n - 1}. */
    private static final float HALF_SPREAD = 0.025f;

    private FinishLobes() {}

    /** 1 if the surface has a finish, else 0. */
    static int isOn(float[] path, int variant) {
        int on = 0;
        if ((variant & Variant.FINISH) != 0) {
            on = path[Layout.IS_FINISHED] > 0f ? 1 : 0;
        }
        return on;
    }

    /**
     * Prepares the surface before its lobes: stretches the facets, and chooses the channel that a dispersive surface
     * refracts, to which the path then belongs.
     *
     * @param bounce number of surfaces that the path has left before
     */
    static void begin(float[] path, int bounce, float[] frame) {
        Grain.begin(path);
        int color = Layout.FINISH + Layout.FINISH_SPECULAR_COLOR;
        int white = (path[color] == 1f ? 1 : 0) & (path[color + 1] == 1f ? 1 : 0) & (path[color + 2] == 1f ? 1 : 0);
        path[Layout.IS_TINTED] = (1 - white) | (path[Layout.FINISH + Layout.FINISH_FILM] > 0f ? 1 : 0);
        if (path[Layout.FINISH + Layout.FINISH_DISPERSION] * path[Layout.TRANSMISSION] > 0f) {
            disperse(path, bounce, frame);
        }
    }

    /** The channel is chosen in proportion to its throughput. */
    private static void disperse(float[] path, int bounce, float[] frame) {
        float red = path[Layout.THROUGHPUT];
        float green = path[Layout.THROUGHPUT + 1];
        float blue = path[Layout.THROUGHPUT + 2];
        float sum = red + green + blue;
        float number = sum * Noise.fresh(path, Noise.dispersion(bounce), frame);
        int isRed = number < red ? 1 : 0;
        int isBlue = number < red + green ? 0 : 1;
        path[Layout.THROUGHPUT] = isRed != 0 ? sum : 0f;
        path[Layout.THROUGHPUT + 1] = (isRed | isBlue) != 0 ? 0f : sum;
        path[Layout.THROUGHPUT + 2] = isBlue != 0 ? sum : 0f;
        float spread = HALF_SPREAD * path[Layout.FINISH + Layout.FINISH_DISPERSION] * (path[Layout.IOR] - 1f);
        path[Layout.IOR] = Math.max(path[Layout.IOR] + spread * (isBlue - isRed), 1f);
    }

    /**
     * Writes what the clear coat and the sheen reflect, and takes it from the lobes below: by the albedo in the
     * direction of the ray's origin, as glTF has it.
     *
     * @param outside 1 on the outer side of the surface, else 0
     */
    static void cover(float[] path, int body, int outside, float[] looks) {
        int row = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_FINISH];
        float coat = outside * path[Layout.FINISH + Layout.FINISH_COAT];
        path[Layout.COVER_COAT] = coat;
        float reflected = coat * ClearCoat.albedo(path, (int) looks[row + Layout.FINISH_COAT_ALBEDO], looks);
        path[Layout.COVER_SHEEN] = outside * (1f - reflected);
        path[Layout.SHEEN_TABLE] = looks[row + Layout.FINISH_SHEEN_ALBEDO];
        float sheen = mostSheen(path) * Sheen.albedo(path, looks);
        path[Layout.CHOICE_COAT] = reflected;
        path[Layout.SHEEN_ALBEDO] = path[Layout.COVER_SHEEN] * sheen;
        float rest = outside != 0 ? (1f - reflected) * (1f - sheen) : 1f;
        path[Layout.PART_MIRROR] = path[Layout.PART_MIRROR] * rest;
        path[Layout.PART_COAT] = path[Layout.PART_COAT] * rest;
        path[Layout.PART_MATTE] = path[Layout.PART_MATTE] * rest;
        path[Layout.PART_GLASS] = path[Layout.PART_GLASS] * rest;
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.SCATTERED_AGAIN + channel] = path[Layout.SCATTERED_AGAIN + channel] * rest;
        }
    }

    private static float mostSheen(float[] path) {
        int color = Layout.FINISH + Layout.FINISH_SHEEN;
        return Math.max(Math.max(path[color], path[color + 1]), path[color + 2]);
    }

    /**
     * Writes what the dielectric reflection leaves to the matte part in the direction of the ray's origin.
     *
     * @param taken what it takes without a tint
     * @param part the part of the surface that reflects so
     */
    static void tint(float[] path, float taken, float part) {
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.UNDER_TINT + channel] = Math.min(Math.max(1f - taken, 0f), 1f);
        }
        if (path[Layout.IS_TINTED] > 0f) {
            float fresnel = part * Refraction.reflectance(path[Layout.FOUND_COSINE], path[Layout.RATIO]);
            meetFacet(path, path[Layout.FOUND_COSINE], fresnel);
            for (int channel = 0; channel < 3; channel++) {
                float more = path[Layout.FACET_DIELECTRIC + channel] - fresnel;
                float left = 1f - taken - path[Layout.FOUND_MIRROR] * more;
                path[Layout.UNDER_TINT + channel] = Math.min(Math.max(left, 0f), 1f);
            }
        }
    }

    /** The factor of the matte part of one channel that stays on this side. */
    static float under(float[] path, int channel, float underCoat) {
        float stays = 1f - path[Layout.FINISH + Layout.FINISH_THROUGH];
        int fromHere = (path[Layout.IS_TINTED] > 0f ? 1 : 0) | (path[Layout.STRETCH] > 1f ? 1 : 0);
        return stays * (fromHere != 0 ? path[Layout.UNDER_TINT + channel] : underCoat);
    }

    /** What passes the matte part of one channel in a direction, times pi. */
    static float through(float[] path, int channel) {
        int color = Layout.FINISH + Layout.FINISH_THROUGH_COLOR;
        return path[Layout.PART_MATTE]
                * path[Layout.UNDER_TINT + channel]
                * path[Layout.FINISH + Layout.FINISH_THROUGH]
                * path[color + channel];
    }

    private static float mostThrough(float[] path) {
        return Math.max(Math.max(through(path, 0), through(path, 1)), through(path, 2));
    }

    /**
     * Writes the probabilities of the finish's own lobes, not yet divided by the sum of all; returns their sum.
     *
     * @param others sum of those of the other lobes
     */
    static float choices(float[] path, float others) {
        float through = mostThrough(path);
        float coat = path[Layout.CHOICE_COAT];
        int rough = ClearCoat.scatters(path);
        coat = rough != 0 ? Math.max(coat, Lobes.LEAST_CHOICE * (others + coat + through)) : coat;
        path[Layout.CHOICE_COAT] = coat;
        path[Layout.CHOICE_THROUGH] = through;
        return coat + through;
    }

    /**
     * Writes the reflectance of a facet of metal and of a dielectric one.
     *
     * @param cosine between the facet and the reversed ray
     * @param fresnel the dielectric reflectance without a tint
     */
    static void meetFacet(float[] path, float cosine, float fresnel) {
        float ratio = path[Layout.RATIO];
        float passed = (float) Math.sqrt(Math.max(Refraction.passedSquared(cosine, ratio), 0f));
        float outer = ratio > 1f ? passed : cosine;
        float root = (path[Layout.IOR] - 1f) / (path[Layout.IOR] + 1f);
        float straight = root * root * (1f - path[Layout.SPECULAR_LOSS]);
        float schlick = schlick(cosine);
        float outerSchlick = schlick(outer);
        float film = path[Layout.FINISH + Layout.FINISH_FILM];
        for (int channel = 0; channel < 3; channel++) {
            float albedo = path[Layout.ALBEDO + channel];
            float color = path[Layout.FINISH + Layout.FINISH_SPECULAR_COLOR + channel];
            float metal = albedo + (1f - albedo) * schlick;
            float dielectric = Math.min(Math.max(fresnel + straight * (color - 1f) * (1f - outerSchlick), 0f), 1f);
            float filmedMetal = 0f;
            float filmedDielectric = 0f;
            if (film > 0f) {
                filmedMetal = ThinFilm.reflectance(path, channel, cosine, albedo);
                filmedDielectric = ThinFilm.reflectance(path, channel, outer, Math.min(straight * color, 1f));
            }
            path[Layout.FACET_METAL + channel] = metal + film * (filmedMetal - metal);
            // Total internal reflection loses nothing.
            path[Layout.FACET_DIELECTRIC + channel] =
                    fresnel < 1f ? dielectric + film * (filmedDielectric - dielectric) : fresnel;
        }
    }

    /** {@code (1 - cosine)^5}. */
    private static float schlick(float cosine) {
        float away = 1f - cosine;
        return away * away * away * away * away;
    }

    /**
     * Adds the sheen, the clear coat if it is rough, and the light that passes to {@link Layout#SCATTERED}.
     *
     * @param cosineOut between the direction and the normal
     * @param faceOut between the direction and the face
     * @return density of the direction by the lobes of the coat and of the light that passes
     */
    static float evaluate(float[] path, float x, float y, float z, float cosineOut, float faceOut, float[] looks) {
        int above = (cosineOut > 0f ? 1 : 0) & (faceOut > 0f ? 1 : 0);
        int below = (cosineOut < 0f ? 1 : 0) & (faceOut < 0f ? 1 : 0);
        float density = 0f;
        if (above != 0) {
            if (path[Layout.SHEEN_ALBEDO] > 0f) {
                float sheen = path[Layout.COVER_SHEEN] * cosineOut * Sheen.evaluate(path, x, y, z, cosineOut, looks);
                for (int channel = 0; channel < 3; channel++) {
                    path[Layout.SCATTERED + channel] = path[Layout.SCATTERED + channel]
                            + sheen * path[Layout.FINISH + Layout.FINISH_SHEEN + channel];
                }
            }
            density = ClearCoat.evaluate(path, x, y, z);
        }
        if (below != 0) {
            float matte = -cosineOut / KernelMath.PI;
            for (int channel = 0; channel < 3; channel++) {
                path[Layout.SCATTERED + channel] = path[Layout.SCATTERED + channel] + matte * through(path, channel);
            }
            density = path[Layout.CHOICE_THROUGH] * matte;
        }
        return density;
    }
}
