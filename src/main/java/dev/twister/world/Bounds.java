package dev.twister.world;

import dev.twister.kernel.Layout;

/** The boxes about some spheres and about their centres alone; grows with each sphere added. */
final class Bounds {
    private static final float NOWHERE = Float.MAX_VALUE;

    float lowX;
    float lowY;
    float lowZ;
    float highX;
    float highY;
    float highZ;

    /** The centres'. */
    float firstX;

    float firstY;
    float firstZ;
    float lastX;
    float lastY;
    float lastZ;

    /** The boxes about the spheres at those places of the hierarchy. */
    void hold(float[] hierarchy, int from, int to) {
        float minX = NOWHERE;
        float minY = NOWHERE;
        float minZ = NOWHERE;
        float maxX = -NOWHERE;
        float maxY = -NOWHERE;
        float maxZ = -NOWHERE;
        float x0 = NOWHERE;
        float y0 = NOWHERE;
        float z0 = NOWHERE;
        float x1 = -NOWHERE;
        float y1 = -NOWHERE;
        float z1 = -NOWHERE;
        for (int at = from; at < to; at += Layout.SPHERE_STRIDE) {
            float x = hierarchy[at];
            float y = hierarchy[at + 1];
            float z = hierarchy[at + 2];
            float radius = hierarchy[at + Layout.SPHERE_RADIUS];
            x0 = x < x0 ? x : x0;
            y0 = y < y0 ? y : y0;
            z0 = z < z0 ? z : z0;
            x1 = x > x1 ? x : x1;
            y1 = y > y1 ? y : y1;
            z1 = z > z1 ? z : z1;
            minX = x - radius < minX ? x - radius : minX;
            minY = y - radius < minY ? y - radius : minY;
            minZ = z - radius < minZ ? z - radius : minZ;
            maxX = x + radius > maxX ? x + radius : maxX;
            maxY = y + radius > maxY ? y + radius : maxY;
            maxZ = z + radius > maxZ ? z + radius : maxZ;
        }
        lowX = minX;
        lowY = minY;
        lowZ = minZ;
        highX = maxX;
        highY = maxY;
        highZ = maxZ;
        firstX = x0;
        firstY = y0;
        firstZ = z0;
        lastX = x1;
        lastY = y1;
        lastZ = z1;
    }
}
