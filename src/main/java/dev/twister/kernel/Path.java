package dev.twister.kernel;

/** A path from a given ray to its end. An engine that renders part of a path by other means continues it here. */
public final class Path {
    private Path() {}

    /**
     * Follows the path's ray, and adds the light found to {@link Layout#RADIANCE}. {@link Layout} describes the arrays.
     *
     * @param path {@link Layout#PATH_LENGTH} floats: the ray, the body that it leaves, throughput, number of surfaces
     *     that it has left, radiance so far, the pixel and its sample; no ray is waiting
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     * @param variant bits of {@link Variant} of a full picture or of a count in {@link Layout#COUNT}
     */
    public static void follow(
            float[] path,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int goesOn = 1;
        while (goesOn != 0) {
            goesOn = step(path, scratch, frame, bodies, looks, meshes, images, variant);
        }
    }

    /**
     * Follows the path's ray to the body that it hits, and replaces it by the next one, which starts there or has been
     * waiting.
     *
     * @return 1 if there is a next ray, else 0
     */
    public static int step(
            float[] path,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int body = Hit.find(path, scratch, frame, bodies, looks, meshes, variant);
        int goesOn = 0;
        int isLight = Surface.isLight(body, looks, variant);
        if (((body >= Layout.PLANE ? 1 : 0) & (1 - isLight)) != 0) {
            meet(path, body, frame, bodies, looks, meshes, images, variant);
            if ((variant & Variant.MATERIALS) != 0) {
                Medium.meet(path, body, looks);
            }
            float visible = 1f;
            float lit = 1f;
            if ((variant & Variant.LIGHTS) != 0) {
                lit = SeveralLights.shade(path, body, 1, scratch, frame, bodies, looks, meshes, variant);
            } else {
                visible = visible(path, body, scratch, frame, bodies, looks, meshes, variant);
                lit = Illumination.lit(
                        Illumination.ambient(path, frame, variant), path[Layout.NORMAL_DOT_LIGHT], visible);
                WhittedLayers.shade(path, scratch, visible, lit, frame, looks, variant);
            }
            WhittedLayers.emit(path, scratch, body, frame, looks, variant);
            Guides.meet(path, mirror(path, frame), transmission(path, frame, variant), variant);
            int waiting = (int) path[Layout.WAITING];
            scatter(path, body, visible, lit, scratch, frame, looks, variant);
            Guides.split(path, waiting, variant);
            Coverage.split(path, body, waiting, frame, looks, variant);
            goesOn = path[Layout.THROUGHPUT] + path[Layout.THROUGHPUT + 1] + path[Layout.THROUGHPUT + 2] > 0f ? 1 : 0;
        }
        int background = body == Layout.NOTHING ? Coverage.sees(path, variant) : 0;
        if (background != 0) {
            Coverage.add(path);
        }
        if (((body == Layout.NOTHING ? 1 : 0) & (1 - background)) != 0) {
            SkyLookup.add(path, frame, images);
            if (Views.isGuided(variant) != 0) {
                SkyLookup.write(path, Layout.DIRECTION, Layout.EMITTED, frame, images);
                LightLayers.add(path, scratch, body, 1f, frame, looks, variant);
                Guides.shine(path, path[Layout.EMITTED], path[Layout.EMITTED + 1], path[Layout.EMITTED + 2], variant);
            }
        }
        if (isLight != 0) {
            if ((variant & Variant.MATERIALS) != 0) {
                Medium.absorb(path, looks);
            }
            Illumination.add(path, body, looks);
            int look = Layout.LOOK_STRIDE * body;
            Guides.shine(path, looks[look], looks[look + 1], looks[look + 2], variant);
            WhittedLayers.meet(path, scratch, body, frame, looks, variant);
        }
        if ((variant & Variant.MATERIALS) != 0) {
            if (((goesOn == 0 ? 1 : 0) & (path[Layout.WAITING] > 0f ? 1 : 0)) != 0) {
                Branch.resume(path, scratch);
                Guides.resume(path, variant);
                Coverage.resume(path, variant);
                goesOn = 1;
            }
        }
        Views.count(path, Views.BOUNCES, goesOn, variant);
        return goesOn;
    }

    /**
     * Writes hit point, normal and material of the surface that the path's ray hits, and the direction to the first
     * light.
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
        SurfaceLook.find(path, body, frame, looks, images, variant);
        if ((variant & Variant.MAPS) != 0) {
            SurfaceMaps.find(path, body, frame, bodies, looks, meshes, images, variant);
        }
        if ((variant & Variant.MATERIALS) != 0) {
            Surface.face(path, body, frame, variant);
        }
        if ((variant & Variant.MAPS) != 0) {
            NormalMap.apply(path, body, frame, bodies, looks, meshes, images, variant);
        }
        Illumination.aim(path, Layout.LIGHT, bodies);
    }

    /** S of the light that shades the surface: {@link Shadow#visible}; 1 if the surface is not shaded. */
    public static float visible(
            float[] path,
            int body,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float visible = 1f;
        if (isShaded(path, frame, variant) != 0) {
            visible = Shadow.visible(path, body, scratch, frame, bodies, looks, meshes, variant);
        }
        return visible;
    }

    /**
     * Adds the surface's reflected light, and replaces the path's ray by the next one; another ray may be left waiting
     * in the scratch.
     *
     * @param visible S in [0, 1]
     * @param lit what matte surfaces are multiplied by
     */
    private static void scatter(
            float[] path,
            int body,
            float visible,
            float lit,
            float[] scratch,
            float[] frame,
            float[] looks,
            int variant) {
        float mirror = mirror(path, frame);
        float transmission = transmission(path, frame, variant);
        Scatter.shade(path, visible, mirror, transmission, lit, looks, variant);
        if ((variant & Variant.MATERIALS) != 0) {
            Scatter.emit(path, body, frame, looks, variant);
            Facet.find(path, frame);
        }
        path[Layout.BOUNCE] = path[Layout.BOUNCE] + 1f;
        if ((variant & Variant.MATERIALS) != 0) {
            Branch.split(path, body, mirror, transmission, lit, scratch, looks);
        } else {
            Scatter.reflect(path, body, mirror * lit);
        }
    }

    /** 0 for perfectly clear glass, whose color does not depend on shadows, else 1. */
    public static int isShaded(float[] path, float[] frame, int variant) {
        return (transmission(path, frame, variant) < 1f ? 1 : 0) | (path[Layout.REFLECTIVITY] > 0f ? 1 : 0);
    }

    /** m of the surface hit, in [0, 1]; 0 at the last bounce. */
    public static float mirror(float[] path, float[] frame) {
        return path[Layout.BOUNCE] < frame[Layout.BOUNCES] ? path[Layout.REFLECTIVITY] / Layout.MAX_REFLECTIVITY : 0f;
    }

    /** t of the surface hit, in [0, 1]; 0 at the last bounce. */
    public static float transmission(float[] path, float[] frame, int variant) {
        float transmission = 0f;
        if ((variant & Variant.MATERIALS) != 0) {
            transmission = path[Layout.BOUNCE] < frame[Layout.BOUNCES] ? path[Layout.TRANSMISSION] : 0f;
        }
        return transmission;
    }
}
