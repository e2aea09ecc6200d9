package dev.twister.kernel;

/** A single shadow ray of {@link Shadow}; used with the hierarchy if a point has too many candidates to store. */
public final class ShadowRay {
    private ShadowRay() {}

    /**
     * The light in [0, 1] that reaches {@link Layout#POINT} along the ray to one sample of the disc.
     * {@link Shadow#visible} is the mean over all samples, computed faster. Writes the disc's axes and half angle.
     *
     * @param sample in [0, shadow samples)
     * @param own the body that the point lies on
     */
    public static float light(
            float[] path,
            int own,
            int sample,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float discRadius = 2f * bodies[Layout.PLACE_STRIDE * Illumination.shading(path, variant) + Layout.PLACE_SIZE];
        Shadow.face(path, discRadius, frame);
        float scale = path[Layout.DISC_SCALE];
        float x = frame[Layout.DISC + 2 * sample] * scale;
        float y = frame[Layout.DISC + 2 * sample + 1] * scale;
        int blocked = PlaneShadow.mayBlock(path, own, discRadius, bodies, looks, variant)
                & PlaneShadow.blocks(path, x, y, bodies, looks, variant);
        float pastPlane = blocked != 0 ? Shadow.transmission(Layout.PLANE, looks, variant) : 1f;
        float light = pastPlane * light(path, own, x, y, scratch, frame, bodies, looks, variant);
        if ((variant & Variant.MESHES) != 0) {
            light = light * MeshShadow.light(path, own, x, y, scratch, frame, bodies, looks, meshes, variant);
        }
        if (Surface.isMesh(own, frame, variant) != 0) {
            light = MeshSurface.looksAway(path) != 0 ? 0f : light;
        }
        return light;
    }

    /**
     * The light in [0, 1] that the spheres transmit along the ray through (1, x, y) * distance, in the frame of A, U
     * (with x = 0) and W; 0 if an opaque one blocks it.
     */
    public static float light(
            float[] path,
            int own,
            float x,
            float y,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            int variant) {
        float pointX = path[Layout.POINT];
        float pointY = path[Layout.POINT + 1];
        float pointZ = path[Layout.POINT + 2];
        float axisX = path[Layout.TO_LIGHT];
        float axisY = path[Layout.TO_LIGHT + 1];
        float axisZ = path[Layout.TO_LIGHT + 2];
        float uY = path[Layout.DISC_U_Y];
        float uZ = path[Layout.DISC_U_Z];
        float wX = path[Layout.DISC_W];
        float wY = path[Layout.DISC_W + 1];
        float wZ = path[Layout.DISC_W + 2];
        float distance = path[Layout.LIGHT_DISTANCE];
        float inverseX = NodeBox.inverse(axisX + wX * y);
        float inverseY = NodeBox.inverse(axisY + uY * x + wY * y);
        float inverseZ = NodeBox.inverse(axisZ + uZ * x + wZ * y);
        float end = distance * Shadow.RELATIVE_MARGIN;
        int node = (int) frame[Layout.SHADOW_ROOT];
        float growth = NodeBox.growth(bodies, node, pointX, pointY, pointZ);
        float light = 1f;
        int waiting = 0;
        while (node != Layout.NO_NODE) {
            int link = (int) bodies[node + Layout.NODE_LINK];
            int spheres = (int) bodies[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            if (spheres < 0) {
                Views.count(path, Views.TESTS, 2, variant);
                float first = NodeBox.entry(bodies, link, pointX, pointY, pointZ, inverseX, inverseY, inverseZ, growth);
                float second = NodeBox.entry(
                        bodies,
                        link + Layout.NODE_STRIDE,
                        pointX,
                        pointY,
                        pointZ,
                        inverseX,
                        inverseY,
                        inverseZ,
                        growth);
                int both = (first < end ? 1 : 0) & (second < end ? 1 : 0);
                if (both != 0) {
                    scratch[Layout.SCRATCH_SHADOW_STACK + waiting] = link + Layout.NODE_STRIDE;
                    waiting = waiting + 1;
                }
                int only = second < end ? link + Layout.NODE_STRIDE : Layout.NO_NODE;
                next = first < end ? link : only;
            }
            int lit = light > 0f ? 1 : 0;
            for (int sphere = 0; sphere < spheres && lit != 0; sphere++) {
                int at = link + Layout.SPHERE_STRIDE * sphere;
                int body = (int) bodies[at + Layout.SPHERE_BODY];
                if (Shadow.isOwn(own, at, body, frame, bodies, variant) == 0) {
                    Views.count(path, Views.TESTS, 1, variant);
                    float toX = bodies[at] - pointX;
                    float toY = bodies[at + 1] - pointY;
                    float toZ = bodies[at + 2] - pointZ;
                    float radius = bodies[at + Layout.SPHERE_RADIUS];
                    float transmission = Shadow.transmission(body, looks, variant);
                    int hit = Shadow.blocks(
                            toX * axisX + toY * axisY + toZ * axisZ,
                            uY * toY + uZ * toZ,
                            wX * toX + wY * toY + wZ * toZ,
                            radius * radius,
                            x,
                            y,
                            distance,
                            transmission);
                    light = hit != 0 ? light * transmission : light;
                    lit = light > 0f ? 1 : 0;
                }
            }
            if (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                next = (int) scratch[Layout.SCRATCH_SHADOW_STACK + waiting];
            }
            node = light > 0f ? next : Layout.NO_NODE;
        }
        return light;
    }
}
