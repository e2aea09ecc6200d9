package dev.twister.explain;

import dev.twister.explain.PathRecorder.Floats;
import dev.twister.explain.PathStep.LightPart;
import dev.twister.explain.PathStep.LightSample;
import dev.twister.explain.PathStep.RayKind;
import dev.twister.explain.PathStep.ShadedSurface;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Illumination;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Path;
import dev.twister.kernel.Refraction;
import dev.twister.kernel.SeveralLights;
import dev.twister.kernel.Shadow;
import dev.twister.kernel.ShadowRay;
import dev.twister.kernel.SpotEmitter;
import dev.twister.scene.Vector3;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.List;

/** One surface of a path, as the path's ray meets it. */
final class SurfaceRecorder {
    private final FrameInput input;
    private final float[] path;
    private final int body;
    private final List<LightPart> lights = new ArrayList<>();

    /**
     * Lets the kernel find the surface.
     *
     * @param path a copy of the path, whose ray has hit the body; it becomes the recorder's
     */
    SurfaceRecorder(FrameInput input, float[] path, float[] scratch, int body) {
        this.input = input;
        this.path = path;
        this.body = body;
        float[] frame = input.view().frame();
        Bodies bodies = input.bodies();
        int variant = input.variant(false);
        Path.meet(path, body, frame, bodies.floats(), bodies.looks(), bodies.meshes(), input.images(), variant);
        for (int light = 0; light < input.lights(); light++) {
            SeveralLights.choose(path, input.light(light), bodies.floats(), bodies.looks());
            lights.add(part(light, scratch));
        }
    }

    /** Of the light that the path is aimed at. */
    private LightPart part(int light, float[] scratch) {
        float[] frame = input.view().frame();
        Bodies bodies = input.bodies();
        float visible = Path.visible(
                path,
                body,
                scratch,
                frame,
                bodies.floats(),
                bodies.looks(),
                bodies.meshes(),
                input.variant(false));
        float cone = SpotEmitter.part(path, Layout.TO_LIGHT, input.light(light), bodies.looks());
        return new LightPart(
                light,
                Floats.vector(path, Layout.TO_LIGHT),
                path[Layout.NORMAL_DOT_LIGHT],
                visible,
                cone,
                bodies.looks()[Layout.LOOK_STRIDE * input.light(light) + Layout.LOOK_SHARE],
                Illumination.highlight(path, visible * cone),
                shadowRays(input.light(light)));
    }

    /** Of a ray that begins at the surface: a refracted one goes on to the side that the ray did not come from. */
    RayKind kindOf(float[] rays, int at) {
        float cameFrom = dot(path, Layout.DIRECTION, path, Layout.NORMAL);
        float goesTo = dot(rays, at + Layout.DIRECTION, path, Layout.NORMAL);
        return cameFrom * goesTo > 0 ? RayKind.REFRACTED : RayKind.REFLECTED;
    }

    /** @param after the path after the kernel's step from this surface, with the sampled facet */
    ShadedSurface shading(float[] after) {
        float[] frame = input.view().frame();
        float transmission = Path.transmission(path, frame, input.variant(false));
        Vector3 origin = input.bodies().origin();
        return new ShadedSurface(
                Floats.place(path, Layout.POINT, origin),
                Floats.vector(path, Layout.NORMAL),
                Floats.rgb(path, Layout.ALBEDO),
                path[Layout.REFLECTIVITY],
                path[Layout.ROUGHNESS],
                path[Layout.IOR],
                List.copyOf(lights),
                lit(Illumination.ambient(path, frame, input.variant(false))),
                Path.mirror(path, frame),
                transmission,
                transmission > 0 ? reflectance(after) : 0);
    }

    /** As the kernel adds it up. */
    private float lit(float ambient) {
        float sum = 0;
        for (LightPart light : lights) {
            float reaching = (float) light.visible() * (float) light.cone();
            sum += (float) light.share() * Math.max(0, (float) light.normalDotLight()) * reaching;
        }
        return Math.max(sum, ambient);
    }

    private float reflectance(float[] after) {
        float cosine = Math.clamp(-dot(path, Layout.DIRECTION, after, Layout.FACET), 0f, 1f);
        float ior = path[Layout.IOR];
        return Refraction.reflectance(cosine, path[Layout.FROM_INSIDE] > 0 ? ior : 1 / ior);
    }

    private List<LightSample> shadowRays(int light) {
        float[] frame = input.view().frame();
        int variant = input.variant(false);
        int traced = Path.isShaded(path, frame, variant) & Shadow.matters(path, frame, variant);
        return traced == 0 ? List.of() : LightSamples.of(input, path, body, light);
    }

    private static float dot(float[] a, int atA, float[] b, int atB) {
        return a[atA] * b[atB] + a[atA + 1] * b[atB + 1] + a[atA + 2] * b[atB + 2];
    }

    /** The shadow rays from a surface point to a light, one by one. */
    private static final class LightSamples {
        private final FrameInput input;
        private final int own;
        private final int light;
        private final float[] path;
        private final float[] scratch = new float[Layout.SCRATCH_LENGTH];

        private LightSamples(FrameInput input, float[] path, int own, int light) {
            this.input = input;
            this.own = own;
            this.light = light;
            this.path = path.clone();
        }

        /**
         * All rays from the path's point.
         *
         * @param path after {@link dev.twister.kernel.SeveralLights#choose}; stays as it is
         * @param own the body that the point lies on
         * @param light the light's body
         */
        static List<LightSample> of(FrameInput input, float[] path, int own, int light) {
            LightSamples rays = new LightSamples(input, path, own, light);
            List<LightSample> all = new ArrayList<>();
            for (int sample = 0; sample < input.shadowSamples(); sample++) {
                all.add(rays.ray(sample));
            }
            return List.copyOf(all);
        }

        private LightSample ray(int sample) {
            Bodies bodies = input.bodies();
            float reaching = ShadowRay.light(
                    path,
                    own,
                    sample,
                    scratch,
                    input.view().frame(),
                    bodies.floats(),
                    bodies.looks(),
                    bodies.meshes(),
                    input.variant(false));
            float[] way = way(sample);
            Vector3 origin = bodies.origin();
            Vector3 target = new Vector3(
                    path[Layout.POINT] + way[0] + origin.x(),
                    path[Layout.POINT + 1] + way[1] + origin.y(),
                    path[Layout.POINT + 2] + way[2] + origin.z());
            return new LightSample(target, reaching, reaching < 1 ? blocker(way) : Layout.NOTHING);
        }

        /** From the point to a sample of the disc, which the kernel has just faced. */
        private float[] way(int sample) {
            float discRadius = 2 * input.bodies().size(light);
            float u = input.view().frame()[Layout.DISC + 2 * sample] * discRadius;
            float w = input.view().frame()[Layout.DISC + 2 * sample + 1] * discRadius;
            float distance = path[Layout.LIGHT_DISTANCE];
            return new float[] {
                distance * path[Layout.TO_LIGHT] + w * path[Layout.DISC_W],
                distance * path[Layout.TO_LIGHT + 1] + u * path[Layout.DISC_U_Y] + w * path[Layout.DISC_W + 1],
                distance * path[Layout.TO_LIGHT + 2] + u * path[Layout.DISC_U_Z] + w * path[Layout.DISC_W + 2]
            };
        }

        private int blocker(float[] way) {
            float[] ray = new float[Layout.PATH_LENGTH];
            float length = (float) Math.sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
            for (int axis = 0; axis < 3; axis++) {
                ray[Layout.ORIGIN + axis] = path[Layout.POINT + axis];
                ray[Layout.DIRECTION + axis] = way[axis] / length;
            }
            ray[Layout.LEAVING] = own;
            ray[Layout.LEAVING_TRIANGLE] = path[Layout.LEAVING_TRIANGLE];
            int body = Hit.find(
                    ray,
                    scratch,
                    input.view().frame(),
                    input.bodies().floats(),
                    input.bodies().looks(),
                    input.bodies().meshes(),
                    input.variant(false));
            boolean between = body != Layout.NOTHING && !input.isLight(body) && ray[Layout.DISTANCE] < length;
            return between ? body : Layout.NOTHING;
        }
    }
}
