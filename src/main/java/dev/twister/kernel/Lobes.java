package dev.twister.kernel;

/**
 * How a surface scatters light in path tracing: a reflection (a mirror, or GGX if rough), a matte part, and
 * transmission. The parts of {@link Layout#PART_MIRROR} and those after it weight them. By Fresnel's equations no light
 * is lost: the matte part has what its coat leaves (Kelemen and Szirmay-Kalos 2001) and what a rough metal scatters
 * more than once (Kulla and Conty 2017); rough glass is scaled to 1.
 */
public final class Lobes {
    /** The lobes: reflection, the matte part, transmission. */
    public static final int MIRROR = 0;

    public static final int MATTE = 1;
    public static final int GLASS = 2;

    /** Those of a finish: the clear coat, and matte light that passes the surface. */
    public static final int COAT = 3;

    public static final int THROUGH = 4;

    /** The least part of the choices that a rough lobe has, so that facets that reflect less are chosen, too. */
    static final float LEAST_CHOICE = 0.05f;

    /** Rough glass of a lower index refracts straight on, which no facet describes. */
    private static final float LEAST_ROUGH_IOR = 1.001f;

    /** The mean of {@code (1 - cos)^5} over all directions. */
    private static final float MEAN_OF_SCHLICK = 1f / 21f;

    private static final float LEAST_COSINE = 1e-6f;
    private static final float LEAST_SQUARE = 1e-12f;

    private Lobes() {}

    /**
     * Writes the weights of the lobes at the path's hit point, and turns the normal and the face toward the ray's
     * origin.
     *
     * @param path {@link Layout#TRACED_PATH_LENGTH} floats, after {@link PathTracer#meet}
     * @param bounce number of surfaces that the path has left before
     */
    public static void prepare(float[] path, int body, int bounce, float[] frame, float[] looks, int variant) {
        int finished = FinishLobes.isOn(path, variant);
        if (finished != 0) {
            FinishLobes.begin(path, bounce, frame);
        }
        int mesh = Surface.isMesh(body, frame, variant);
        float side = Facet.directionDot(path, Layout.NORMAL) > 0f ? -1f : 1f;
        float along = Facet.directionDot(path, Layout.FACE);
        float faceSide = along > 0f ? -1f : 1f;
        for (int axis = 0; axis < 3; axis++) {
            float normal = side * path[Layout.NORMAL + axis];
            path[Layout.NORMAL + axis] = normal;
            path[Layout.FACE + axis] = mesh != 0 ? faceSide * path[Layout.FACE + axis] : normal;
        }
        int fresnel = path[Layout.IS_FRESNEL] > 0f ? 1 : 0;
        float metal = path[Layout.METALLIC];
        float given = path[Layout.REFLECTIVITY] / Layout.MAX_REFLECTIVITY;
        int beside = path[Layout.IS_FRESNEL] < 0f ? 1 : 0;
        float mirror = beside != 0 ? metal + (1f - metal) * given : given;
        // Of what is reflected at all.
        path[Layout.METALLIC] = beside != 0 ? metal / Math.max(mirror, LEAST_SQUARE) : metal;
        float transmission = path[Layout.TRANSMISSION];
        float constant = fresnel != 0 ? metal : mirror;
        path[Layout.PART_MIRROR] = constant;
        path[Layout.PART_COAT] = fresnel != 0 ? 1f - metal : (1f - mirror) * transmission;
        path[Layout.PART_GLASS] = (1f - constant) * transmission;
        path[Layout.PART_MATTE] = (1f - constant) * (1f - transmission);
        float ior = path[Layout.IOR];
        path[Layout.RATIO] = isInside(path) != 0 ? ior : 1f / Math.max(ior, 1f);
        int smooth =
                (path[Layout.ROUGHNESS] > 0f ? 0 : 1) | ((transmission > 0f ? 1 : 0) & (ior < LEAST_ROUGH_IOR ? 1 : 0));
        path[Layout.ROUGHNESS] = smooth != 0 ? 0f : path[Layout.ROUGHNESS];
        path[Layout.COAT_ALBEDO] = 0f;
        path[Layout.UNDER_COAT] = 1f;
        path[Layout.MEAN_UNDER_COAT] = 1f;
        path[Layout.MEAN_AGAIN] = 0f;
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.SCATTERED_AGAIN + channel] = 0f;
        }
        if (fresnel != 0) {
            keep(path, (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_ALBEDOS], looks, variant);
        }
        if (finished != 0) {
            FinishLobes.cover(path, body, 1 - isInside(path), looks);
        }
        choices(path, variant);
    }

    /**
     * Writes the factors by which the lobes together lose no light.
     *
     * @param tables place of {@link DirectionalAlbedo}'s tables
     */
    private static void keep(float[] path, int tables, float[] looks, int variant) {
        float cosine = Math.min(Math.max(-Facet.directionDot(path, Layout.NORMAL), 0f), 1f);
        float roughness = path[Layout.ROUGHNESS];
        int inside = isInside(path);
        int mirror = tables + DirectionalAlbedo.MIRROR * DirectionalAlbedo.TABLE_LENGTH;
        int coat = tables + DirectionalAlbedo.COAT * DirectionalAlbedo.TABLE_LENGTH;
        int glass = tables + (DirectionalAlbedo.GLASS + inside) * DirectionalAlbedo.TABLE_LENGTH;
        int stretched = findAlbedos(path, variant);
        path[Layout.MIRROR_ALBEDO] = stretched != 0 ? 0 : mirror;
        path[Layout.COAT_ALBEDO] = coat;
        float coated = coated(path);
        float left = 1f - coated * DirectionalAlbedo.mean(coat, roughness, looks);
        float taken = coated * albedo(path, coat, Layout.FOUND_COAT, cosine, looks, variant);
        path[Layout.UNDER_COAT] = (1f - taken) / Math.max(left, LEAST_SQUARE);
        path[Layout.MEAN_UNDER_COAT] = left;
        float once = albedo(path, mirror, Layout.FOUND_MIRROR, cosine, looks, variant);
        float mean = stretched != 0 ? once : DirectionalAlbedo.mean(mirror, roughness, looks);
        float meanAgain = stretched != 0 ? 1f : 1f - mean;
        path[Layout.MEAN_AGAIN] = meanAgain;
        float again = path[Layout.PART_MIRROR] * (1f - once) / Math.max(meanAgain, LEAST_SQUARE);
        for (int channel = 0; channel < 3; channel++) {
            float albedo = path[Layout.ALBEDO + channel];
            float reflected = albedo + (1f - albedo) * MEAN_OF_SCHLICK;
            path[Layout.SCATTERED_AGAIN + channel] =
                    again * reflected * reflected * mean / Math.max(1f - reflected * (1f - mean), LEAST_SQUARE);
        }
        // Through a sheet light leaves as if it were reflected.
        float whole =
                path[Layout.IS_SHEET] > 0f ? once : albedo(path, glass, Layout.FOUND_GLASS, cosine, looks, variant);
        float scale = roughness > 0f ? 1f / whole : 1f;
        float transmission = path[Layout.TRANSMISSION];
        float coats = inside != 0 ? 0f : 1f - transmission;
        path[Layout.PART_COAT] = path[Layout.PART_COAT] * (coats + transmission * scale);
        path[Layout.PART_GLASS] = path[Layout.PART_GLASS] * scale;
        if (FinishLobes.isOn(path, variant) != 0) {
            FinishLobes.tint(path, taken, coated);
        }
    }

    /** Writes the albedos of stretched and tinted facets; returns 1 if they are stretched, else 0. */
    private static int findAlbedos(float[] path, int variant) {
        int stretched = 0;
        if (FinishLobes.isOn(path, variant) != 0) {
            stretched = path[Layout.STRETCH] > 1f ? 1 : 0;
            if ((stretched | (path[Layout.IS_TINTED] > 0f ? 1 : 0)) != 0) {
                FinishAlbedos.find(path);
            }
        }
        return stretched;
    }

    /**
     * An albedo in the direction of the ray's origin.
     *
     * @param table its place in {@code looks}
     * @param found its place in the path, if the facets are stretched
     */
    private static float albedo(float[] path, int table, int found, float cosine, float[] looks, int variant) {
        float albedo = DirectionalAlbedo.of(table, path[Layout.ROUGHNESS], cosine, looks);
        if (FinishLobes.isOn(path, variant) != 0) {
            albedo = path[Layout.STRETCH] > 1f ? path[found] : albedo;
        }
        return albedo;
    }

    /** The part of the dielectric reflectance that coats the matte part, which has no coat inside the body. */
    private static float coated(float[] path) {
        return isInside(path) != 0 ? 0f : 1f - path[Layout.SPECULAR_LOSS];
    }

    /** 1 if the ray comes from inside a body of some thickness, else 0. */
    private static int isInside(float[] path) {
        return (path[Layout.FROM_INSIDE] > 0f ? 1 : 0) & (path[Layout.IS_SHEET] > 0f ? 0 : 1);
    }

    /**
     * What the matte part scatters of one channel's light in a direction, times pi; without a coat the same for all.
     */
    private static float matte(float[] path, int channel, float underCoat, float again, int variant) {
        float under = underCoat;
        if (FinishLobes.isOn(path, variant) != 0) {
            under = FinishLobes.under(path, channel, underCoat);
        }
        return path[Layout.PART_MATTE] * under * path[Layout.ALBEDO + channel]
                + again * path[Layout.SCATTERED_AGAIN + channel];
    }

    /** Writes with which probability each lobe is chosen: in proportion to its largest channel, at the normal. */
    private static void choices(float[] path, int variant) {
        float cosine = Math.min(Math.max(-Facet.directionDot(path, Layout.NORMAL), 0f), 1f);
        float fresnel = fresnel(path, cosine);
        float largest = largestAlbedo(path);
        meetFacet(path, cosine, fresnel, variant);
        float mirror = mostReflected(path, cosine, fresnel, variant);
        float underCoat = path[Layout.UNDER_COAT] * path[Layout.MEAN_UNDER_COAT];
        float again = path[Layout.MEAN_AGAIN];
        float matte = Math.max(
                Math.max(matte(path, 0, underCoat, again, variant), matte(path, 1, underCoat, again, variant)),
                matte(path, 2, underCoat, again, variant));
        float glass = mostPassed(path, fresnel, variant);
        float finish = 0f;
        if (FinishLobes.isOn(path, variant) != 0) {
            matte = matte + path[Layout.SHEEN_ALBEDO];
            finish = FinishLobes.choices(path, mirror + matte + glass);
        }
        if (path[Layout.ROUGHNESS] > 0f) {
            float sum = mirror + matte + glass + finish;
            float least = LEAST_CHOICE * (sum > 0f ? sum : 1f);
            mirror = path[Layout.PART_MIRROR] + path[Layout.PART_COAT] > 0f ? Math.max(mirror, least) : mirror;
            glass = path[Layout.PART_GLASS] * largest > 0f ? Math.max(glass, least) : glass;
        }
        float sum = mirror + matte + glass + finish;
        float inverse = sum > 0f ? 1f / sum : 0f;
        path[Layout.CHOICE_MIRROR] = mirror * inverse;
        path[Layout.CHOICE_MATTE] = matte * inverse;
        path[Layout.CHOICE_GLASS] = glass * inverse;
        if (FinishLobes.isOn(path, variant) != 0) {
            path[Layout.CHOICE_COAT] = path[Layout.CHOICE_COAT] * inverse;
            path[Layout.CHOICE_THROUGH] = path[Layout.CHOICE_THROUGH] * inverse;
        }
    }

    /** The dielectric reflectance at a facet; 0 without a dielectric part. */
    private static float fresnel(float[] path, float cosine) {
        float fresnel = 0f;
        if (path[Layout.PART_COAT] > 0f) {
            float whole = Refraction.reflectance(cosine, path[Layout.RATIO]);
            // Total internal reflection loses nothing.
            fresnel = whole < 1f ? whole * (1f - path[Layout.SPECULAR_LOSS]) : whole;
        }
        return fresnel;
    }

    /**
     * Writes the reflectance of a facet under a finish, before what follows is asked of that facet.
     *
     * @param fresnel its reflectance without a finish
     */
    private static void meetFacet(float[] path, float cosine, float fresnel, int variant) {
        if (FinishLobes.isOn(path, variant) != 0) {
            FinishLobes.meetFacet(path, cosine, fresnel);
        }
    }

    /** The reflected part of one channel at a facet, after {@link #meetFacet}. */
    private static float reflected(float[] path, int channel, float cosine, float fresnel, int variant) {
        float away = 1f - cosine;
        float schlick = path[Layout.IS_FRESNEL] != 0f ? away * away * away * away * away : 0f;
        float albedo = path[Layout.ALBEDO + channel];
        float edge = albedo + (1f - albedo) * schlick;
        float metal = path[Layout.IS_FRESNEL] > 0f ? edge : 1f + path[Layout.METALLIC] * (edge - 1f);
        float reflected = path[Layout.PART_MIRROR] * metal + path[Layout.PART_COAT] * fresnel;
        if (FinishLobes.isOn(path, variant) != 0) {
            reflected = path[Layout.PART_MIRROR] * path[Layout.FACET_METAL + channel]
                    + path[Layout.PART_COAT] * path[Layout.FACET_DIELECTRIC + channel];
        }
        return reflected;
    }

    /** The part of one channel that passes a facet, after {@link #meetFacet}. */
    private static float passed(float[] path, int channel, float fresnel, int variant) {
        float reflected = fresnel;
        if (FinishLobes.isOn(path, variant) != 0) {
            reflected = path[Layout.FACET_DIELECTRIC + channel];
        }
        return path[Layout.PART_GLASS] * (1f - reflected) * path[Layout.ALBEDO + channel];
    }

    /** The largest channel of what a facet reflects. */
    private static float mostReflected(float[] path, float cosine, float fresnel, int variant) {
        return Math.max(
                Math.max(reflected(path, 0, cosine, fresnel, variant), reflected(path, 1, cosine, fresnel, variant)),
                reflected(path, 2, cosine, fresnel, variant));
    }

    /** The largest channel of what passes a facet. */
    private static float mostPassed(float[] path, float fresnel, int variant) {
        return Math.max(
                Math.max(passed(path, 0, fresnel, variant), passed(path, 1, fresnel, variant)),
                passed(path, 2, fresnel, variant));
    }

    private static float largestAlbedo(float[] path) {
        return Math.max(Math.max(path[Layout.ALBEDO], path[Layout.ALBEDO + 1]), path[Layout.ALBEDO + 2]);
    }

    /** 1 if light from other than single directions is scattered, so that emitters are worth sampling. */
    public static int scatters(float[] path, int variant) {
        int finish = 0;
        if (FinishLobes.isOn(path, variant) != 0) {
            finish = ClearCoat.scatters(path) | (path[Layout.CHOICE_THROUGH] > 0f ? 1 : 0);
        }
        return finish
                | (path[Layout.CHOICE_MATTE] > 0f ? 1 : 0)
                | ((path[Layout.ROUGHNESS] > 0f ? 1 : 0)
                        & (path[Layout.CHOICE_MIRROR] + path[Layout.CHOICE_GLASS] > 0f ? 1 : 0));
    }

    /**
     * Writes {@code f * |cos|} of a direction, of the lobes that are not mirror-like, to {@link Layout#SCATTERED}.
     *
     * @return density per steradian with which {@link #choose} takes the direction, of these lobes together
     */
    public static float evaluate(float[] path, float x, float y, float z, float[] looks, int variant) {
        float cosineOut = path[Layout.NORMAL] * x + path[Layout.NORMAL + 1] * y + path[Layout.NORMAL + 2] * z;
        float faceOut = path[Layout.FACE] * x + path[Layout.FACE + 1] * y + path[Layout.FACE + 2] * z;
        float cosineIn = Math.max(-Facet.directionDot(path, Layout.NORMAL), LEAST_COSINE);
        int above = (cosineOut > 0f ? 1 : 0) & (faceOut > 0f ? 1 : 0);
        int below = (cosineOut < 0f ? 1 : 0) & (faceOut < 0f ? 1 : 0) & (path[Layout.PART_GLASS] > 0f ? 1 : 0);
        float density = 0f;
        path[Layout.SCATTERED] = 0f;
        path[Layout.SCATTERED + 1] = 0f;
        path[Layout.SCATTERED + 2] = 0f;
        if (above != 0) {
            float underCoat = 1f;
            float again = 0f;
            if (path[Layout.COAT_ALBEDO] > 0f) {
                float cosine = Math.min(cosineOut, 1f);
                float roughness = path[Layout.ROUGHNESS];
                float coat = DirectionalAlbedo.of((int) path[Layout.COAT_ALBEDO], roughness, cosine, looks);
                underCoat = path[Layout.UNDER_COAT] * (1f - coated(path) * coat);
                int mirror = (int) path[Layout.MIRROR_ALBEDO];
                again = mirror > 0 ? 1f - DirectionalAlbedo.of(mirror, roughness, cosine, looks) : 1f;
            }
            float matte = cosineOut / KernelMath.PI;
            for (int channel = 0; channel < 3; channel++) {
                path[Layout.SCATTERED + channel] = matte * matte(path, channel, underCoat, again, variant);
            }
            density = path[Layout.CHOICE_MATTE] * matte;
        }
        if (((above | below) & (path[Layout.ROUGHNESS] > 0f ? 1 : 0)) != 0) {
            density = density + rough(path, x, y, z, cosineIn, cosineOut, variant);
        }
        if (FinishLobes.isOn(path, variant) != 0) {
            density = density + FinishLobes.evaluate(path, x, y, z, cosineOut, faceOut, looks);
        }
        return density;
    }

    /** Adds the rough reflection or transmission to {@link Layout#SCATTERED}. */
    private static float rough(float[] path, float x, float y, float z, float cosineIn, float cosineOut, int variant) {
        int passes = cosineOut < 0f ? 1 : 0;
        int sheet = passes & (path[Layout.IS_SHEET] > 0f ? 1 : 0);
        int refracts = passes & (1 - sheet);
        // Through a sheet light leaves as if it were reflected on the other side.
        float turned = sheet != 0 ? -2f * cosineOut : 0f;
        float outX = x + turned * path[Layout.NORMAL];
        float outY = y + turned * path[Layout.NORMAL + 1];
        float outZ = z + turned * path[Layout.NORMAL + 2];
        float ratio = refracts != 0 ? path[Layout.RATIO] : 1f;
        float halfX = outX - ratio * path[Layout.DIRECTION];
        float halfY = outY - ratio * path[Layout.DIRECTION + 1];
        float halfZ = outZ - ratio * path[Layout.DIRECTION + 2];
        float lengthSquared = halfX * halfX + halfY * halfY + halfZ * halfZ;
        float inverse = KernelMath.inverseRoot(lengthSquared);
        float normalDotHalf =
                (halfX * path[Layout.NORMAL] + halfY * path[Layout.NORMAL + 1] + halfZ * path[Layout.NORMAL + 2])
                        * inverse;
        float turn = normalDotHalf < 0f ? -inverse : inverse;
        float viewDotHalf = -turn
                * (halfX * path[Layout.DIRECTION]
                        + halfY * path[Layout.DIRECTION + 1]
                        + halfZ * path[Layout.DIRECTION + 2]);
        float outDotHalf = turn * (halfX * outX + halfY * outY + halfZ * outZ);
        float alpha = path[Layout.ROUGHNESS] * path[Layout.ROUGHNESS];
        float visible = visible(
                path, turn * halfX, turn * halfY, turn * halfZ, Math.abs(normalDotHalf), cosineIn, alpha, variant);
        int seen = (viewDotHalf > 0f ? 1 : 0) & (refracts != 0 ? (outDotHalf < 0f ? 1 : 0) : 1);
        float refracted = viewDotHalf * Math.abs(outDotHalf) / Math.max(lengthSquared, LEAST_SQUARE);
        float facets = seen != 0 ? visible * (refracts != 0 ? refracted : 0.25f) : 0f;
        float in = masked(
                path,
                path[Layout.DIRECTION],
                path[Layout.DIRECTION + 1],
                path[Layout.DIRECTION + 2],
                cosineIn,
                variant);
        float out = masked(path, x, y, z, Math.abs(cosineOut), variant);
        float weight = facets * Facet.weight(path[Layout.ROUGHNESS], in, out);
        float cosine = Math.min(Math.max(viewDotHalf, 0f), 1f);
        float fresnel = fresnel(path, cosine);
        meetFacet(path, cosine, fresnel, variant);
        for (int channel = 0; channel < 3; channel++) {
            float part = passes != 0
                    ? passed(path, channel, fresnel, variant)
                    : reflected(path, channel, cosine, fresnel, variant);
            path[Layout.SCATTERED + channel] = path[Layout.SCATTERED + channel] + weight * part;
        }
        float choice = path[Layout.CHOICE_MIRROR] + path[Layout.CHOICE_GLASS];
        float mirrors = mirrorShare(path, cosine, fresnel, variant);
        return facets * choice * (passes != 0 ? 1f - mirrors : mirrors);
    }

    /** {@link Facet#visibleDensity} of a unit facet, which a finish may have stretched. */
    private static float visible(
            float[] path, float x, float y, float z, float cosine, float cosineIn, float alpha, int variant) {
        float density = 0f;
        if (FinishLobes.isOn(path, variant) != 0) {
            density = Grain.visibleDensity(path, x, y, z, cosine, cosineIn, alpha);
        } else {
            density = Facet.visibleDensity(alpha, cosine, cosineIn);
        }
        return density;
    }

    /** The cosine of a direction that decides how much of it the facets mask. */
    private static float masked(float[] path, float x, float y, float z, float cosine, int variant) {
        float masked = cosine;
        if (FinishLobes.isOn(path, variant) != 0) {
            masked = Grain.masked(path, x, y, z, cosine);
        }
        return masked;
    }

    /** The part of the rays that meet a facet which it reflects; the others pass. */
    private static float mirrorShare(float[] path, float cosine, float fresnel, int variant) {
        float share = 1f;
        if (path[Layout.PART_GLASS] > 0f) {
            float mirror = mostReflected(path, cosine, fresnel, variant);
            float glass = mostPassed(path, fresnel, variant);
            share = glass > 0f ? mirror / (mirror + glass) : 1f;
        }
        return share;
    }

    /**
     * Chooses a lobe and a direction. Writes the direction and whether it continues inside the body; multiplies the
     * throughput by {@code f * |cos| / density}, which is 0 if the path ends; and writes the density to
     * {@link Layout#SURFACE_DENSITY}, 0 for a mirror-like lobe. A rough surface chooses between reflection and
     * transmission by what its facet reflects, and writes these probabilities.
     *
     * @param bounce number of surfaces that the path has left before
     */
    public static void choose(float[] path, int bounce, float[] frame, float[] looks, int variant) {
        int place = Noise.scatter(bounce);
        float first = Noise.fresh(path, place + 1, frame);
        float second = Noise.fresh(path, place + 2, frame);
        path[Layout.FACET] = path[Layout.NORMAL];
        path[Layout.FACET + 1] = path[Layout.NORMAL + 1];
        path[Layout.FACET + 2] = path[Layout.NORMAL + 2];
        if (path[Layout.ROUGHNESS] > 0f) {
            sampleFacet(path, first, second, variant);
            float cosine = Math.min(Math.max(-Facet.directionDot(path, Layout.FACET), 0f), 1f);
            float choice = path[Layout.CHOICE_MIRROR] + path[Layout.CHOICE_GLASS];
            float fresnel = fresnel(path, cosine);
            meetFacet(path, cosine, fresnel, variant);
            float mirrors = mirrorShare(path, cosine, fresnel, variant);
            path[Layout.CHOICE_MIRROR] = choice * mirrors;
            path[Layout.CHOICE_GLASS] = choice * (1f - mirrors);
        }
        int lobe = chosen(path, bounce, frame, variant);
        int glass = lobe == GLASS ? 1 : 0;
        int through = 0;
        int coat = 0;
        if (FinishLobes.isOn(path, variant) != 0) {
            through = lobe == THROUGH ? 1 : 0;
            coat = lobe == COAT ? 1 : 0;
            if (coat != 0) {
                ClearCoat.sampleFacet(path, first, second);
            }
        }
        int matte = (lobe == MATTE ? 1 : 0) | through;
        if (matte != 0) {
            float sine = (float) Math.sqrt(first);
            TangentFrame.write(
                    path,
                    Layout.NEXT_DIRECTION,
                    path[Layout.NORMAL],
                    path[Layout.NORMAL + 1],
                    path[Layout.NORMAL + 2],
                    sine * KernelMath.cosineOfTurns(second),
                    sine * KernelMath.sineOfTurns(second),
                    (through != 0 ? -1f : 1f) * (float) Math.sqrt(Math.max(1f - first, 0f)));
        }
        if (matte == 0) {
            bend(path, glass);
        }
        int crosses = (glass | through) & (path[Layout.IS_SHEET] > Layout.SHEET_OF_BODY ? 0 : 1);
        float inside = path[Layout.FROM_INSIDE];
        path[Layout.NEXT_INSIDE] = crosses != 0 ? Branch.crossed(inside > 0f ? 0 : 1) : inside;
        int spread = matte | (spreads(path, coat, variant) > 0f ? 1 : 0);
        if (spread == 0) {
            mirrorLike(path, glass, coat, variant);
        }
        if (spread != 0) {
            float density = evaluate(
                    path,
                    path[Layout.NEXT_DIRECTION],
                    path[Layout.NEXT_DIRECTION + 1],
                    path[Layout.NEXT_DIRECTION + 2],
                    looks,
                    variant);
            int goesOn = (density > 0f ? 1 : 0) & isOnSide(path, glass, through);
            float inverse = goesOn != 0 ? 1f / density : 0f;
            path[Layout.SURFACE_DENSITY] = goesOn != 0 ? density : 0f;
            multiply(
                    path,
                    path[Layout.SCATTERED] * inverse,
                    path[Layout.SCATTERED + 1] * inverse,
                    path[Layout.SCATTERED + 2] * inverse);
        }
    }

    /**
     * The lobe that {@link #choose} has chosen: {@link #MIRROR}, {@link #MATTE} or {@link #GLASS}.
     *
     * @param bounce number of surfaces that the path has left before
     */
    public static int chosen(float[] path, int bounce, float[] frame, int variant) {
        float number = Noise.fresh(path, Noise.scatter(bounce), frame);
        int lobe = chosen(path, number);
        if (FinishLobes.isOn(path, variant) != 0) {
            float coat = path[Layout.CHOICE_COAT];
            float finish = coat + path[Layout.CHOICE_THROUGH];
            int below = chosen(path, number - finish);
            int above = number < coat ? COAT : THROUGH;
            lobe = number < finish ? above : below;
        }
        return lobe;
    }

    private static int chosen(float[] path, float number) {
        int spreads = number < path[Layout.CHOICE_MIRROR] + path[Layout.CHOICE_MATTE] ? MATTE : GLASS;
        return number < path[Layout.CHOICE_MIRROR] ? MIRROR : spreads;
    }

    /** The probability with which {@link #choose} has chosen a lobe. */
    public static float choice(float[] path, int lobe) {
        return path[lobe < COAT ? Layout.CHOICE_MIRROR + lobe : Layout.CHOICE_COAT + lobe - COAT];
    }

    private static void sampleFacet(float[] path, float first, float second, int variant) {
        if (FinishLobes.isOn(path, variant) != 0) {
            Grain.sampleFacet(path, first, second);
        } else {
            Facet.sample(path, first, second);
        }
    }

    /** The roughness of the facets that have been sampled: those of the coat, or those below. */
    private static float spreads(float[] path, int coat, int variant) {
        float roughness = path[Layout.ROUGHNESS];
        if (FinishLobes.isOn(path, variant) != 0) {
            roughness = coat != 0 ? path[Layout.FINISH + Layout.FINISH_COAT_ROUGHNESS] : roughness;
        }
        return roughness;
    }

    /**
     * 1 if the next ray is on the side of the surface that its lobe leads to, else 0. A facet that reflects totally
     * refracts nowhere.
     */
    private static int isOnSide(float[] path, int glass, int through) {
        float height = path[Layout.NORMAL] * path[Layout.NEXT_DIRECTION]
                + path[Layout.NORMAL + 1] * path[Layout.NEXT_DIRECTION + 1]
                + path[Layout.NORMAL + 2] * path[Layout.NEXT_DIRECTION + 2];
        float cosine = Math.min(Math.max(-Facet.directionDot(path, Layout.FACET), 0f), 1f);
        int passes = (height < 0f ? 1 : 0) & ((fresnel(path, cosine) < 1f ? 1 : 0) | through);
        return (glass | through) != 0 ? passes : (height > 0f ? 1 : 0);
    }

    /** Multiplies the throughput by the weight of a perfect mirror, of clear glass, or of a smooth coat. */
    private static void mirrorLike(float[] path, int glass, int coat, int variant) {
        float cosine = Math.min(Math.max(-Facet.directionDot(path, Layout.NORMAL), 0f), 1f);
        float fresnel = fresnel(path, cosine);
        meetFacet(path, cosine, fresnel, variant);
        float choice = glass != 0 ? path[Layout.CHOICE_GLASS] : path[Layout.CHOICE_MIRROR];
        float faceOut = path[Layout.FACE] * path[Layout.NEXT_DIRECTION]
                + path[Layout.FACE + 1] * path[Layout.NEXT_DIRECTION + 1]
                + path[Layout.FACE + 2] * path[Layout.NEXT_DIRECTION + 2];
        int leaves = glass != 0 ? (faceOut < 0f ? 1 : 0) : (faceOut > 0f ? 1 : 0);
        float inverse = (leaves & (choice > 0f ? 1 : 0)) != 0 ? 1f / choice : 0f;
        path[Layout.SURFACE_DENSITY] = 0f;
        float red = mirrored(path, 0, glass, cosine, fresnel, variant);
        float green = mirrored(path, 1, glass, cosine, fresnel, variant);
        float blue = mirrored(path, 2, glass, cosine, fresnel, variant);
        if (coat == 0) {
            multiply(path, red * inverse, green * inverse, blue * inverse);
        } else {
            float mirrored = ClearCoat.mirrored(path);
            multiply(path, mirrored, mirrored, mirrored);
        }
    }

    private static float mirrored(float[] path, int channel, int glass, float cosine, float fresnel, int variant) {
        return glass != 0
                ? passed(path, channel, fresnel, variant)
                : reflected(path, channel, cosine, fresnel, variant);
    }

    private static void multiply(float[] path, float red, float green, float blue) {
        path[Layout.THROUGHPUT] = path[Layout.THROUGHPUT] * red;
        path[Layout.THROUGHPUT + 1] = path[Layout.THROUGHPUT + 1] * green;
        path[Layout.THROUGHPUT + 2] = path[Layout.THROUGHPUT + 2] * blue;
    }

    /** Writes the ray reflected or refracted at the facet. */
    private static void bend(float[] path, int glass) {
        float cosine = Math.min(Math.max(-Facet.directionDot(path, Layout.FACET), 0f), 1f);
        float ratio = path[Layout.RATIO];
        float reflectedX = path[Layout.DIRECTION] + 2f * cosine * path[Layout.FACET];
        float reflectedY = path[Layout.DIRECTION + 1] + 2f * cosine * path[Layout.FACET + 1];
        float reflectedZ = path[Layout.DIRECTION + 2] + 2f * cosine * path[Layout.FACET + 2];
        float height = reflectedX * path[Layout.NORMAL]
                + reflectedY * path[Layout.NORMAL + 1]
                + reflectedZ * path[Layout.NORMAL + 2];
        int sheet = glass & (path[Layout.IS_SHEET] > 0f ? 1 : 0);
        int refracts = glass & (1 - sheet);
        float turned = sheet != 0 ? -2f * height : 0f;
        float along = Refraction.along(cosine, ratio);
        float x = refracts != 0
                ? ratio * path[Layout.DIRECTION] + along * path[Layout.FACET]
                : reflectedX + turned * path[Layout.NORMAL];
        float y = refracts != 0
                ? ratio * path[Layout.DIRECTION + 1] + along * path[Layout.FACET + 1]
                : reflectedY + turned * path[Layout.NORMAL + 1];
        float z = refracts != 0
                ? ratio * path[Layout.DIRECTION + 2] + along * path[Layout.FACET + 2]
                : reflectedZ + turned * path[Layout.NORMAL + 2];
        float inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
        path[Layout.NEXT_DIRECTION] = x * inverse;
        path[Layout.NEXT_DIRECTION + 1] = y * inverse;
        path[Layout.NEXT_DIRECTION + 2] = z * inverse;
    }
}
