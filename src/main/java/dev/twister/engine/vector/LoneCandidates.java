package dev.twister.engine.vector;

import dev.twister.kernel.KernelMath;
import dev.twister.kernel.SoftShadow;
import java.util.Arrays;

/** The spheres that may come between one point and the light's disc, in the frame of {@link SoftShadow}; grows, never shrinks. */
final class LoneCandidates {
    /** Floats a candidate: a, u, w, radius squared. */
    static final int STRIDE = 4;

    float[] facts = new float[64 * STRIDE];
    int count;

    /** Metres to the disc. */
    float distance;

    private float slope;
    private float slant;
    private float own;
    private float pointX;
    private float pointY;
    private float pointZ;
    private float axisX;
    private float axisY;
    private float axisZ;
    private float uY;
    private float uZ;
    private float wX;
    private float wY;
    private float wZ;

    /** Forgets the candidates of the point before; this one's axes are the kernel's. */
    void start(float[] t, int pixel) {
        count = 0;
        distance = t[pixel + Tile.LIGHT_DISTANCE];
        slope = t[pixel + Tile.DISC_TANGENT];
        slant = t[pixel + Tile.DISC_SECANT];
        own = t[pixel + Tile.HIT];
        pointX = t[pixel + Tile.POINT_X];
        pointY = t[pixel + Tile.POINT_Y];
        pointZ = t[pixel + Tile.POINT_Z];
        axisX = t[pixel + Tile.TO_LIGHT_X];
        axisY = t[pixel + Tile.TO_LIGHT_Y];
        axisZ = t[pixel + Tile.TO_LIGHT_Z];
        float acrossSquared = axisY * axisY + axisZ * axisZ;
        float scale = KernelMath.inverseRoot(acrossSquared > 0f ? acrossSquared : axisX * axisX);
        uY = acrossSquared > 0f ? axisZ * scale : 0f;
        uZ = acrossSquared > 0f ? -axisY * scale : axisX * scale;
        wX = uY * axisZ - uZ * axisY;
        wY = uZ * axisX;
        wZ = -uY * axisX;
    }

    /** Adds a sphere of the columns where it is a candidate; returns whether it hides the whole disc. */
    boolean judge(WideHierarchy hierarchy, int sphere) {
        int judgement = SoftShadow.HARMLESS;
        if (hierarchy.bodies[sphere] != own) {
            float x = hierarchy.x[sphere] - pointX;
            float y = hierarchy.y[sphere] - pointY;
            float z = hierarchy.z[sphere] - pointZ;
            float radius = hierarchy.radius[sphere];
            float a = x * axisX + y * axisY + z * axisZ;
            float u = uY * y + uZ * z;
            float w = wX * x + wY * y + wZ * z;
            judgement = SoftShadow.judge(a, u, w, radius, distance, slope, slant);
            if (judgement == SoftShadow.CANDIDATE) {
                add(a, u, w, radius * radius);
            }
        }
        return judgement == SoftShadow.HIDES_ALL;
    }

    private void add(float a, float u, float w, float radiusSquared) {
        int at = count * STRIDE;
        if (at == facts.length) {
            facts = Arrays.copyOf(facts, 2 * facts.length);
        }
        facts[at] = a;
        facts[at + 1] = u;
        facts[at + 2] = w;
        facts[at + 3] = radiusSquared;
        count++;
    }
}
