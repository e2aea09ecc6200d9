package dev.twister.mesh;

import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.SceneLimits;
import java.util.ArrayList;
import java.util.List;

/** The lights of a file, which have no size, as balls around its mesh: near ones are small, far ones like the sun. */
final class StageLights {
    /** Radius of a near light, as a part of the mesh's. */
    private static final double SMALL = 0.002;

    /** Distance of a far light, in radii of the mesh. */
    private static final double FAR = 100;

    /** Radius of the sun over its distance. */
    private static final double SUN = 0.00465;

    private final Vector3 center;
    private final double radius;

    /** A light, and the direction from the mesh's center to it. */
    private record Placed(Light light, Vector3 toLight) {}

    /**
     * @param center of the mesh
     * @param radius half of the mesh's largest side
     */
    StageLights(Vector3 center, double radius) {
        this.center = center;
        this.radius = radius;
    }

    /**
     * The lights of a scene. Where they would light the center more brightly than white, all are dimmed by the same
     * factor: files do not say for which exposure their lights are.
     *
     * @param lights at least one, in the scene's coordinates
     * @param scale meters in the scene per meter of the file
     */
    Lights of(List<FileLight> lights, double scale) {
        List<Placed> placed = lights.stream().map(light -> placed(light, scale)).toList();
        double dimmed = 1 / Math.max(1, brightest(placed));
        List<Light> used = new ArrayList<>();
        for (Placed one : placed) {
            Light light = one.light();
            Light dim = light.withShare(LightProperties.SHARE.range().clamp(dimmed * light.share()));
            used.add(light.strength()
                    .map(strength ->
                            dim.withStrength(LightProperties.STRENGTH.range().clamp(dimmed * strength)))
                    .orElse(dim));
        }
        return new Lights(used);
    }

    private Placed placed(FileLight light, double scale) {
        Vector3 toNear = light.position().minus(center);
        boolean far = light.kind() == FileLight.Kind.FAR;
        Vector3 place = far ? light.direction().times(-FAR * radius) : toNear;
        double distance = Math.max(place.length(), radius);
        // A white surface at the distance of 1 m has this radiance; distances are scaled, and light at the mesh is not.
        double strength = light.intensity() / Math.PI * (far ? distance * distance : scale * scale);
        double share = luminance(light.color()) * strength / (distance * distance);
        Light ball = Light.of(
                        SceneLimits.POSITION.clamp(center.plus(place)),
                        far ? SUN * distance : SMALL * radius,
                        light.color())
                .withStrength(strength)
                .withShare(share);
        return new Placed(ball, place.length() > 0 ? place.normalized() : place);
    }

    /** How brightly a white surface at the center is lit that faces the light from whose side it is lit most. */
    private static double brightest(List<Placed> lights) {
        double brightest = 0;
        for (Placed faced : lights) {
            double sum = 0;
            for (Placed other : lights) {
                sum += other.light().share() * Math.max(0, faced.toLight().dot(other.toLight()));
            }
            brightest = Math.max(brightest, sum);
        }
        return brightest;
    }

    private static double luminance(Rgb color) {
        return 0.2126 * color.red() + 0.7152 * color.green() + 0.0722 * color.blue();
    }
}
