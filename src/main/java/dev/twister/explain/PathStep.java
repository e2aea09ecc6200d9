package dev.twister.explain;

import dev.twister.kernel.Layout;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.Optional;

/**
 * A ray of a pixel's path, and what it meets.
 *
 * @param parent the index of the step whose surface it leaves; {@link #NO_PARENT} for the view ray
 * @param bounce how many surfaces the path has left before, 0 for the view ray
 * @param origin in the scene's meters
 * @param direction a unit vector
 * @param inside whether it goes through the inside of a transparent body
 * @param throughput what part of the radiance it finds reaches the pixel
 * @param body what it meets, as view {@code body} numbers it: {@link Layout#NOTHING} is the sky, {@link Layout#LIGHT}
 *     the first light, {@link Layout#PLANE} the plane, spheres follow
 * @param light the number of the light that it meets, from 0; {@link #NO_LIGHT} if it meets none
 * @param distance in meters; 0 where it meets nothing
 * @param shading of the surface it meets; none for a light and the sky
 * @param adds radiance that the step adds to the pixel's sample
 */
public record PathStep(
        int parent,
        RayKind kind,
        int bounce,
        Vector3 origin,
        Vector3 direction,
        boolean inside,
        Rgb throughput,
        int body,
        int light,
        double distance,
        Optional<ShadedSurface> shading,
        Rgb adds) {
    public static final int NO_PARENT = -1;
    public static final int NO_LIGHT = -1;

    /** Such as {@code sky}, {@code light}, {@code light 2}, {@code plane} or {@code body 5}. */
    public String meets() {
        return light > 0 ? "light " + (light + 1) : bodyName(body);
    }

    /** As above, for what is no light but the first. */
    public static String bodyName(int body) {
        return switch (body) {
            case Layout.NOTHING -> "sky";
            case Layout.LIGHT -> "light";
            case Layout.PLANE -> "plane";
            default -> "body " + body;
        };
    }
}
