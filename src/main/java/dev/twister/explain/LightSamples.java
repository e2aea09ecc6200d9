package dev.twister.explain;

import dev.twister.explain.PathStep.LightSample;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Layout;
import dev.twister.kernel.ShadowRay;
import dev.twister.scene.Vector3;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.List;

/** The shadow rays from a surface point to a light, one by one. */
final class LightSamples {
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
