package dev.twister.render;

import dev.twister.render.RenderOrder.Movement;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.io.IOException;
import java.util.Optional;

/** The scene of an order at the times of its frames. */
final class FilmFrames {
    /**
     * Side, in meters, of the cubes that share an origin if the camera is far from the scene's own. It depends on the
     * camera alone, so that a frame is the same whichever frames were rendered before it.
     */
    private static final double CUBE = 2048;

    private final Scene scene;
    private final World world;
    private final FilmBodies bodies;
    private final Movement movement;
    private Optional<World> far = Optional.empty();
    private Optional<Double> metered = Optional.empty();
    private int number;

    FilmFrames(RenderOrder order, World world, FilmBodies bodies) {
        scene = order.scene();
        movement = order.movement();
        this.world = world;
        this.bodies = bodies;
    }

    /** The world of the frames near the scene's origin. */
    World world() {
        return world;
    }

    /**
     * A frame at its time, when the shutter closes.
     *
     * @param next at least that of the previous call
     * @throws IOException if the bodies' positions cannot be read
     */
    FrameInput frame(int next) throws IOException {
        number = next;
        bodies.advance(number);
        return at(1);
    }

    /**
     * The last frame at a moment while the shutter is open.
     *
     * @param part of that time, in [0, 1]; 1 is the frame's own
     */
    FrameInput at(double part) {
        double earlier = movement.shutter() * (1 - part);
        Scene now = movement.scene().apply((number - earlier) / movement.rate());
        World near = near(now.camera());
        near.show(metered.map(stops -> now.withRendering(now.rendering().withExposure(stops)))
                .orElse(now));
        bodies.place(near, 1 - earlier);
        near.placeLights();
        return near.snapshot();
    }

    /** Sets the exposure of all frames, whatever the scene says. */
    void setExposure(double stops) {
        metered = Optional.of(stops);
    }

    private World near(Camera seen) {
        if (world.isNear(seen)) {
            return world;
        }
        Vector3 place = seen.position();
        Vector3 middle = new Vector3(middle(place.x()), middle(place.y()), middle(place.z()));
        if (far.isEmpty() || !far.get().origin().equals(middle)) {
            far = Optional.of(World.of(scene.withCamera(seen.withPosition(middle)), world.images(), world.meshes()));
        }
        return far.get();
    }

    private static double middle(double coordinate) {
        return (Math.floor(coordinate / CUBE) + 0.5) * CUBE;
    }
}
