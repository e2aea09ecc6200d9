package dev.twister.kernel;

/**
 * The visible parts of the light at a strip's points, see {@link SoftShadow}: the cones and which spheres meet them in
 * loops over the lanes, then, in each lane that is left, its samples in loops over them.
 */
final class StripShadow {
    private StripShadow() {}

    /** Copies the disc's points to where a compiler knows that the loops over them write nothing else. */
    static void copyDisc(int samples, float[] shadowDisc, float[] lanes) {
        for (int sample = 0; sample < samples; sample++) {
            lanes[Strip.SAMPLE_X + sample] = shadowDisc[2 * sample];
            lanes[Strip.SAMPLE_Y + sample] = shadowDisc[2 * sample + 1];
        }
    }

    /** Finds the cone from each lane's point to the disc. */
    static void cone(int pixels, float discRadius, int samples, float[] shadowDisc, float[] lanes) {
        float rimX = shadowDisc[2 * samples - 2];
        float rimY = shadowDisc[2 * samples - 1];
        float rim = (float) Math.sqrt(rimX * rimX + rimY * rimY);
        for (int lane = 0; lane < pixels; lane++) {
            float distance = lanes[Strip.LIGHT_DISTANCE + lane];
            float sampleScale = distance > 0f ? discRadius * (1f / distance) : 0f;
            float slope = sampleScale * rim;
            lanes[Strip.SAMPLE_SCALE + lane] = sampleScale;
            lanes[Strip.SLOPE + lane] = slope;
            lanes[Strip.SLANT + lane] = (float) Math.sqrt(1f + slope * slope);
        }
    }

    /** Of few spheres: leaves no lane marked whose cone none of them may meet. */
    static void cull(int pixels, float[] hierarchy, int root, float[] lanes, int[] marks) {
        for (int lane = 0; lane < pixels; lane++) {
            marks[Strip.MET + lane] = 0;
        }
        for (int sphere = 0; sphere < root; sphere = sphere + Layout.SPHERE_STRIDE) {
            float centerX = hierarchy[sphere + Layout.SPHERE_CENTER];
            float centerY = hierarchy[sphere + Layout.SPHERE_CENTER + 1];
            float centerZ = hierarchy[sphere + Layout.SPHERE_CENTER + 2];
            float radius = hierarchy[sphere + Layout.SPHERE_RADIUS];
            int body = (int) hierarchy[sphere + Layout.SPHERE_BODY];
            for (int lane = 0; lane < pixels; lane++) {
                float x = centerX - lanes[Strip.POINT_X + lane];
                float y = centerY - lanes[Strip.POINT_Y + lane];
                float z = centerZ - lanes[Strip.POINT_Z + lane];
                float axisX = lanes[Strip.TO_LIGHT_X + lane];
                float axisY = lanes[Strip.TO_LIGHT_Y + lane];
                float axisZ = lanes[Strip.TO_LIGHT_Z + lane];
                float a = x * axisX + y * axisY + z * axisZ;
                float acrossX = x - a * axisX;
                float acrossY = y - a * axisY;
                float acrossZ = z - a * axisZ;
                int meets = SoftShadow.mayMeet(
                        a,
                        acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ,
                        radius,
                        lanes[Strip.LIGHT_DISTANCE + lane],
                        lanes[Strip.SLOPE + lane],
                        lanes[Strip.SLANT + lane]);
                int others = marks[Strip.HIT + lane] != body ? 1 : 0;
                marks[Strip.MET + lane] = marks[Strip.MET + lane] | (meets & others);
            }
        }
        for (int lane = 0; lane < pixels; lane++) {
            marks[Strip.SHADED + lane] = marks[Strip.SHADED + lane] & marks[Strip.MET + lane];
        }
    }

    /** Finds S in each lane: 1 where it is not marked. */
    static void find(
            int pixels, int samples, float[] hierarchy, int root, float[] lanes, int[] marks, float[] scratch) {
        for (int lane = 0; lane < pixels; lane++) {
            float visible = 1f;
            if (marks[Strip.SHADED + lane] != 0) {
                visible = visible(lane, samples, hierarchy, root, lanes, marks, scratch);
            }
            lanes[Strip.VISIBLE + lane] = visible;
        }
    }

    private static float visible(
            int lane, int samples, float[] hierarchy, int root, float[] lanes, int[] marks, float[] scratch) {
        float pointX = lanes[Strip.POINT_X + lane];
        float pointY = lanes[Strip.POINT_Y + lane];
        float pointZ = lanes[Strip.POINT_Z + lane];
        int own = marks[Strip.HIT + lane];
        float axisX = lanes[Strip.TO_LIGHT_X + lane];
        float axisY = lanes[Strip.TO_LIGHT_Y + lane];
        float axisZ = lanes[Strip.TO_LIGHT_Z + lane];
        float distance = lanes[Strip.LIGHT_DISTANCE + lane];
        float sampleScale = lanes[Strip.SAMPLE_SCALE + lane];
        float scale = SoftShadow.axesScale(axisX, axisY, axisZ);
        float uY = SoftShadow.uY(axisY, axisZ, scale);
        float uZ = SoftShadow.uZ(axisX, axisY, axisZ, scale);
        float wX = uY * axisZ - uZ * axisY;
        float wY = uZ * axisX;
        float wZ = -uY * axisX;
        int count = SoftShadow.candidates(
                pointX,
                pointY,
                pointZ,
                own,
                axisX,
                axisY,
                axisZ,
                uY,
                uZ,
                wX,
                wY,
                wZ,
                distance,
                lanes[Strip.SLOPE + lane],
                lanes[Strip.SLANT + lane],
                hierarchy,
                root,
                scratch);
        float visible = count == SoftShadow.ALL_HIDDEN ? 0f : 1f;
        if (count > 0) {
            block(Math.min(count, Layout.MOST_CANDIDATES), samples, sampleScale, distance, scratch, lanes, marks);
            if (count > Layout.MOST_CANDIDATES) {
                for (int sample = 0; sample < samples; sample++) {
                    if (marks[Strip.BLOCKED + sample] == 0) {
                        float x = lanes[Strip.SAMPLE_X + sample] * sampleScale;
                        float y = lanes[Strip.SAMPLE_Y + sample] * sampleScale;
                        marks[Strip.BLOCKED + sample] = SampleRay.blocked(
                                pointX, pointY, pointZ, own, axisX, axisY, axisZ, uY, uZ, wX, wY, wZ, x, y, distance,
                                hierarchy, root, scratch);
                    }
                }
            }
            int blocked = 0;
            for (int sample = 0; sample < samples; sample++) {
                blocked = blocked + marks[Strip.BLOCKED + sample];
            }
            visible = 1f - (float) blocked / samples;
        }
        return visible;
    }

    /** Marks the samples that the candidates in the scratch block, and no others. */
    private static void block(
            int candidates,
            int samples,
            float sampleScale,
            float distance,
            float[] scratch,
            float[] lanes,
            int[] marks) {
        for (int sample = 0; sample < samples; sample++) {
            marks[Strip.BLOCKED + sample] = 0;
        }
        for (int candidate = 0; candidate < candidates; candidate++) {
            float a = scratch[Layout.CANDIDATE_STRIDE * candidate];
            float u = scratch[Layout.CANDIDATE_STRIDE * candidate + 1];
            float w = scratch[Layout.CANDIDATE_STRIDE * candidate + 2];
            float radiusSquared = scratch[Layout.CANDIDATE_STRIDE * candidate + 3];
            for (int sample = 0; sample < samples; sample++) {
                float x = lanes[Strip.SAMPLE_X + sample] * sampleScale;
                float y = lanes[Strip.SAMPLE_Y + sample] * sampleScale;
                int blocks = SoftShadow.blocks(a, u, w, radiusSquared, x, y, distance);
                marks[Strip.BLOCKED + sample] = marks[Strip.BLOCKED + sample] | blocks;
            }
        }
    }
}
