package dev.twister.gui.model;

import dev.twister.scene.Body;
import dev.twister.scene.Light;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import java.util.List;
import java.util.stream.Stream;

/**
 * Spheres, meshes and lights that are copied together.
 *
 * @param bodies spheres and meshes
 * @param apart so far to the right, in meters, another group like it does not touch it
 */
public record BodyGroup(List<Body> bodies, List<Light> lights, double apart) {
    public BodyGroup {
        bodies = List.copyOf(bodies);
        lights = List.copyOf(lights);
    }

    public int count() {
        return bodies.size() + lights.size();
    }

    /** What they are called in a sentence, such as {@code sphere} or {@code 3 bodies}. */
    public String kind() {
        if (count() > 1) {
            return count() + " bodies";
        }
        return bodies.isEmpty() ? "light" : bodies.getFirst().kind();
    }

    /** The same to the right, or as far as the scene has room for all of them. */
    public BodyGroup beside() {
        double right = Stream.concat(
                        bodies.stream().map(Body::position), lights.stream().map(Light::position))
                .mapToDouble(Vector3::x)
                .max()
                .orElseThrow();
        Vector3 way = new Vector3(Math.min(apart, SceneLimits.POSITION.max() - right), 0, 0);
        return new BodyGroup(
                bodies.stream()
                        .map(body -> body.withPosition(moved(body.position(), way)))
                        .toList(),
                lights.stream()
                        .map(light -> light.withPosition(moved(light.position(), way)))
                        .toList(),
                apart);
    }

    private static Vector3 moved(Vector3 place, Vector3 way) {
        return SceneLimits.POSITION.clamp(place.plus(way));
    }
}
