package dev.twister.scene.generate;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.SceneLimits;
import dev.twister.scene.select.Title;
import java.nio.file.Path;
import java.util.List;

/** Makes scenes of many spheres: the same arguments give the same scene on every machine. */
public final class SceneGenerator {
    /** The most spheres that a scene may have. */
    public static final int MAX_SPHERES = SceneLimits.MAX_SPHERES;

    /** Above it, strewing spheres at random would take long, and look like noise. */
    private static final int MAX_MEADOW = 1000;

    private SceneGenerator() {}

    /**
     * Makes a scene of spheres of varied size, color and reflectivity on and over a checkered plane, none of which
     * overlap, with the camera and the light placed for it: up to 1,000 as a meadow about three large ones, more as a
     * vortex of spiral waves.
     *
     * @param count how many spheres, 1 to {@value #MAX_SPHERES}
     * @param seed any number; another one gives other colors and places
     * @param skybox the panorama's file; not looked at
     * @throws SceneException if the count is out of range
     */
    public static Scene spheres(int count, long seed, Path skybox) {
        if (count < 1 || count > MAX_SPHERES) {
            throw new SceneException("the number of spheres is " + count + ", but must be from 1 to " + MAX_SPHERES);
        }
        return count <= MAX_MEADOW ? meadow(count, seed, skybox) : vortex(count, seed, skybox);
    }

    private static Scene meadow(int count, long seed, Path skybox) {
        double reach = SphereMeadow.discRadius(count);
        return Scene.under(skybox)
                .withTitle(new Title(
                        "Meadow of " + count + (count == 1 ? " sphere" : " spheres"),
                        "Spheres strewn about three large ones; made by Twister, seed " + seed + "."))
                .withCamera(lookingAtCenter(2.15 * reach, 0.5 * reach, 0.06 * reach, 29))
                .withLights(Lights.of(light(new Vector3(-0.8 * reach, 1.6 * reach, -1.3 * reach), 0.12 * reach)))
                .withGround(plane(4 * reach, new Rgb(0.62, 0.6, 0.56), new Rgb(0.4, 0.39, 0.38)))
                .withSpheres(SphereMeadow.spheres(count, seed))
                .withRendering(Rendering.DEFAULT.withShadowSamples(32).withBounces(4));
    }

    private static Scene vortex(int count, long seed, Path skybox) {
        double reach = SphereVortex.DISC_RADIUS;
        List<Sphere> spheres = SphereVortex.spheres(count, seed);
        return Scene.under(skybox)
                .withTitle(new Title(
                        "Vortex of " + count + " spheres",
                        "Spiral waves of spheres about a mirror; made by Twister, seed " + seed + "."))
                .withCamera(lookingAtCenter(1.45 * reach, 0.75 * reach, 0, 40))
                .withLights(Lights.of(light(new Vector3(-0.7 * reach, 0.9 * reach, -0.5 * reach), 0.06 * reach)))
                .withGround(plane(2.6 * reach, new Rgb(0.42, 0.42, 0.44), new Rgb(0.24, 0.24, 0.26)))
                .withSpheres(spheres)
                .withRendering(Rendering.DEFAULT.withShadowSamples(16).withBounces(2));
    }

    // From in front of the spheres, so that the point at a height on the y axis is in the picture's middle.
    private static Camera lookingAtCenter(double distance, double height, double targetHeight, double fieldOfView) {
        double pitch = StrictMath.toDegrees(StrictMath.atan2(height - targetHeight, distance));
        Vector3 position = new Vector3(0, height, -distance);
        return Camera.of(Rounding.of(position), 0, Rounding.of(pitch), fieldOfView);
    }

    private static Light light(Vector3 position, double radius) {
        return Light.of(Rounding.of(position), Rounding.of(radius), new Rgb(1, 1, 1));
    }

    private static Ground plane(double size, Rgb evenColor, Rgb oddColor) {
        // A whole number of checks on either side of the axis.
        return Ground.of(2 * Math.ceil(size / 2), 0, evenColor, oddColor, 28);
    }
}
