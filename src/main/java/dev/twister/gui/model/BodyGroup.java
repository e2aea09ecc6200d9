package dev.twister.gui.model;

import dev.twister.scene.Body;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Vector3;
import java.util.List;

/**
 * Spheres and meshes that are copied together.
 *
 * @param bodies at least one
 * @param apart so far to the right, in meters, another group like it does not touch it
 */
public record BodyGroup(List<Body> bodies, double apart) {
    public BodyGroup {
        bodies = List.copyOf(bodies);
    }

    /** What they are called in a sentence, such as {@code sphere} or {@code 3 bodies}. */
    public String kind() {
        return bodies.size() == 1 ? bodies.getFirst().kind() : bodies.size() + " bodies";
    }

    /** The same to the right, or as far as the scene has room for all of them. */
    public BodyGroup beside() {
        double right =
                bodies.stream().mapToDouble(body -> body.position().x()).max().orElseThrow();
        double room = Math.min(apart, SceneLimits.POSITION.max() - right);
        Vector3 way = new Vector3(room, 0, 0);
        return new BodyGroup(
                bodies.stream()
                        .map(body -> body.withPosition(
                                SceneLimits.POSITION.clamp(body.position().plus(way))))
                        .toList(),
                apart);
    }
}
