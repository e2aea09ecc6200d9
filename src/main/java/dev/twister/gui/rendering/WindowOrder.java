package dev.twister.gui.rendering;

import dev.twister.engine.EngineOffer;
import dev.twister.render.Background;
import dev.twister.render.ExistingFrames;
import dev.twister.render.Finishing;
import dev.twister.render.FrameRange;
import dev.twister.render.PicturePart;
import dev.twister.render.RenderOrder;
import dev.twister.render.RenderOrder.BodyMotion;
import dev.twister.render.RenderOrder.Movement;
import dev.twister.render.RenderOutput;
import dev.twister.render.Sampling;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.Animation;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;

/** Orders of the window's render dialog; their files are those of {@code twister render}. */
public final class WindowOrder {
    private WindowOrder() {}

    /**
     * An order of a single picture.
     *
     * @param moving with the size and the samples to render with, and how it moves around the picture's time
     * @param seen a picture with the bodies' positions; empty for those of the scene
     */
    public static RenderOrder picture(
            MovingScene moving, StageOrView picture, EngineOffer engine, Optional<FrameInput> seen, Path file) {
        BodyMotion bodies = seen.<BodyMotion>map(BodyMotion.Seen::new).orElse(new BodyMotion.Still());
        Scene scene = moving.scene().apply(0);
        return of(
                scene,
                picture,
                engine,
                new Movement(bodies, moving.scene(), moving.rate(), shutter(scene, Animation.isIn(scene))),
                new RenderOutput(file, Optional.empty(), ExistingFrames.REPLACED, Background.SKY));
    }

    /**
     * An order of a film or of numbered pictures.
     *
     * @param scene with the size and the samples to render with
     */
    public static RenderOrder film(Scene scene, StageOrView picture, EngineOffer engine, FilmPlan film, Path file) {
        return of(
                scene,
                picture,
                engine,
                film.movement(scene),
                new RenderOutput(file, Optional.of(film.frames()), ExistingFrames.REPLACED, Background.SKY));
    }

    private static RenderOrder of(
            Scene scene, StageOrView picture, EngineOffer engine, Movement movement, RenderOutput output) {
        Sampling sampling = new Sampling(scene.rendering().samplesPerPixel(), Optional.empty());
        return new RenderOrder(
                scene, engine, List.of(picture), sampling, PicturePart.WHOLE, movement, Finishing.NONE, output);
    }

    private static double shutter(Scene scene, boolean moves) {
        return moves ? scene.rendering().shutter() : 0;
    }

    /**
     * A scene around the time of a picture.
     *
     * @param scene by the seconds after that time, below 0 before it
     * @param rate frames per second, by which the shutter opens
     */
    public record MovingScene(DoubleFunction<Scene> scene, double rate) {}

    /**
     * A film that the window renders.
     *
     * @param rate frames per second
     */
    public record FilmPlan(FilmMotion motion, double rate, FrameRange frames) {
        /** What moves in the film of a scene. */
        Movement movement(Scene scene) {
            // As the command computes it, so that times agree to the last bit.
            double secondsPerFrame = 1 / rate;
            return new Movement(
                    motion.movesBodies() ? new BodyMotion.Simulated(0, secondsPerFrame) : new BodyMotion.Still(),
                    motion.followsKeyframes() ? seconds -> Animation.at(scene, seconds) : _ -> scene,
                    1 / secondsPerFrame,
                    shutter(scene, true));
        }
    }

    /** What moves in a film. */
    public enum FilmMotion {
        KEYFRAMES("Keyframes", true, false),
        PHYSICS("Physics", false, true),
        KEYFRAMES_AND_PHYSICS("Keyframes and physics", true, true);

        private static final Vector3 NONE = Vector3.ZERO;

        /** One keyframe moves nothing. */
        private static final int FEWEST_KEYFRAMES = 2;

        private final String label;
        private final boolean keyframes;
        private final boolean physics;

        FilmMotion(String label, boolean keyframes, boolean physics) {
            this.label = label;
            this.keyframes = keyframes;
            this.physics = physics;
        }

        /** What can move in a scene; empty if nothing can. */
        public static List<FilmMotion> of(Scene scene) {
            boolean path = scene.camera().keyframes().size() >= FEWEST_KEYFRAMES
                    || scene.tracks().stream()
                            .anyMatch(track -> track.keyframes().size() >= FEWEST_KEYFRAMES)
                    || Animation.isOfMeshes(scene);
            boolean bodies = !scene.spheres().isEmpty() || scene.pour().isPresent();
            boolean falls = bodies && !scene.physics().gravity().equals(NONE);
            return Arrays.stream(values())
                    .filter(motion -> (path || !motion.keyframes) && (falls || !motion.physics))
                    .toList();
        }

        /** The displayed name. */
        public String label() {
            return label;
        }

        /** Whether the camera, bodies and whatever else has keyframes follow them. */
        public boolean followsKeyframes() {
            return keyframes;
        }

        /** Whether bodies are simulated. */
        public boolean movesBodies() {
            return physics;
        }
    }
}
