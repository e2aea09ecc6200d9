package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.OutputFile;
import dev.twister.film.FilmFile;
import dev.twister.motion.MotionFile;
import dev.twister.render.ExistingFrames;
import dev.twister.render.FrameRange;
import dev.twister.render.NumberedFiles;
import dev.twister.render.RenderOrder.BodyMotion;
import dev.twister.render.RenderOrder.Movement;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.property.SceneLimits;
import dev.twister.scene.property.SceneProperties;
import dev.twister.world.Animation;
import dev.twister.world.SceneMeshes;
import dev.twister.world.animation.CameraPath;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.DoubleFunction;
import picocli.CommandLine.Option;

/** Options for the frames of a film, and for what moves in them besides physics. */
public final class FilmOptions {
    private static final double MAX_SECONDS = 86_400;

    @Option(
            names = "--frames",
            paramLabel = "RANGE",
            converter = FrameRangeConverter.class,
            description = "Render frames of a film: N for frames 0 to N-1, A-B for frames A to B, to FILE-0000.png,"
                    + " FILE-0001.png, ...; %%04d or #### in FILE is the place of the number. Default: all of --motion"
                    + " or --turntable, or of the scene's keyframes and animations for a film, numbered files or with"
                    + " --fps.")
    private Optional<FrameRange> frames = Optional.empty();

    @Option(
            names = "--motion",
            paramLabel = "FILE",
            description = "Take the bodies' positions from a motion file (see 'twister simulate').")
    private Optional<Path> motion = Optional.empty();

    @Option(
            names = "--turntable",
            paramLabel = "SECONDS",
            description = "Turn the camera once around the spheres in this time.")
    private Optional<Double> turntable = Optional.empty();

    @Option(
            names = "--time",
            paramLabel = "SECONDS",
            description =
                    "Render one picture at this time of the film of the scene's keyframes and animations. Default: the"
                            + " scene's own values.")
    private Optional<Double> time = Optional.empty();

    @Option(
            names = "--shutter",
            paramLabel = "X",
            description = "Motion blur: how long the shutter is open before a frame's time, as a fraction of a frame, 0"
                    + " to 1. Needs samples: the more, the smoother.")
    private Optional<Double> shutter = Optional.empty();

    @Option(
            names = "--skip-existing",
            description = "With frames: keep files that are whole and of the same scene, settings and version; render"
                    + " the others again.")
    private boolean skipExisting;

    @Option(names = "--overwrite", description = "With frames: replace the frames of an earlier run.")
    private boolean overwrite;

    public boolean skipsExisting() {
        return skipExisting;
    }

    public ExistingFrames existing() {
        return skipExisting ? ExistingFrames.KEPT : overwrite ? ExistingFrames.REPLACED : ExistingFrames.REFUSED;
    }

    /** Rejects options that exclude each other. */
    public void check(MotionOptions physics) {
        if (motion.isPresent() && (physics.isOn() || physics.isTimeGiven())) {
            throw new BadInputException(
                    "--motion excludes --physics, --fps and --start: the motion file has all of them");
        }
        turntable.ifPresent(seconds -> Ranges.check("--turntable", seconds, 1e-3, MAX_SECONDS));
        time.ifPresent(seconds -> Ranges.check("--time", seconds, SceneLimits.KEYFRAME_TIME));
        boolean moved = physics.isOn() || physics.isStartGiven() || motion.isPresent() || turntable.isPresent();
        if (time.isPresent() && (moved || frames.isPresent())) {
            throw new BadInputException("--time excludes --frames, --start, --physics, --motion and --turntable: it"
                    + " renders one picture of the scene's keyframes or animations");
        }
        if (skipExisting && overwrite) {
            throw new BadInputException("--skip-existing and --overwrite exclude each other; give one of them");
        }
    }

    /** Opens the motion file; empty without {@code --motion}. */
    public Optional<MotionFile> open(Scene scene) throws IOException {
        return motion.isPresent() ? Optional.of(MotionFile.open(motion.get(), scene)) : Optional.empty();
    }

    /**
     * The frames to render; empty for a single picture.
     *
     * @param meshes of the scene, whose animations have lengths
     * @param output a film, numbered files or a picture
     */
    public Optional<FrameRange> frames(
            Scene scene, SceneMeshes meshes, MotionOptions physics, Optional<MotionFile> recorded, Path output)
            throws IOException {
        return time.isPresent() ? single(scene, output) : framesOf(scene, meshes, physics, recorded, output);
    }

    private static boolean isNumbered(Path output) {
        return !OutputFile.isStandardOutput(output) && NumberedFiles.hasPlace(output);
    }

    private Optional<FrameRange> framesOf(
            Scene scene, SceneMeshes meshes, MotionOptions physics, Optional<MotionFile> recorded, Path output)
            throws IOException {
        boolean several = FilmFile.isFilm(output) || isNumbered(output);
        boolean moves = physics.isOn() || recorded.isPresent() || turntable.isPresent() || Animation.isIn(scene);
        if (!moves) {
            if (frames.isPresent() || physics.isTimeGiven() || several) {
                throw new BadInputException(
                        (frames.isPresent() ? "--frames" : physics.isTimeGiven() ? "--fps and --start" : kind(output))
                                + " requires --physics, --motion, --turntable, or a scene with keyframes or an"
                                + " animation: otherwise nothing moves");
            }
            return Optional.empty();
        }
        physics.checkStart();
        if (frames.isPresent()) {
            if (recorded.isPresent()) {
                // Fails before the first frame is rendered, not after the last one in the file.
                recorded.get().frame(frames.get().first());
                recorded.get().frame(frames.get().last());
            }
            return frames;
        }
        if (recorded.isPresent()) {
            return Optional.of(whole(recorded.get()));
        }
        double rate = 1 / physics.secondsPerFrame();
        if (turntable.isPresent()) {
            return Optional.of(counted(Math.max(1, Math.round(turntable.get() * rate))));
        }
        boolean whole = several || skipExisting || overwrite;
        if (Animation.isIn(scene) && (whole || (!physics.isOn() && physics.isTimeGiven()))) {
            return Optional.of(counted(Animation.frames(scene, meshes, rate)));
        }
        if (whole) {
            throw new BadInputException((several ? kind(output) : skipExisting ? "--skip-existing" : "--overwrite")
                    + " requires --frames, as physics have no end");
        }
        return Optional.empty();
    }

    private static String kind(Path output) {
        return FilmFile.isFilm(output) ? "a film" : "--output " + output + ", a name of numbered frames,";
    }

    private static FrameRange counted(long count) {
        if (count > FrameRange.MOST) {
            throw new BadInputException(
                    "the film has " + count + " frames, but at most " + FrameRange.MOST + " are possible; lower --fps");
        }
        return FrameRange.ofCount((int) count);
    }

    private FrameRange whole(MotionFile recorded) throws IOException {
        if (recorded.lastFrame() < recorded.firstFrame()) {
            throw new BadInputException("--motion is " + motion.orElseThrow() + ", which has no whole frame");
        }
        return FrameRange.of(recorded.firstFrame(), recorded.lastFrame());
    }

    private static Optional<FrameRange> single(Scene scene, Path output) {
        if (FilmFile.isFilm(output) || isNumbered(output)) {
            throw new BadInputException("--time renders one picture, but --output is "
                    + (FilmFile.isFilm(output) ? "a film" : output + ", a name of numbered frames")
                    + "; give --frames for a part of a film");
        }
        if (!Animation.isIn(scene)) {
            throw new BadInputException(
                    "--time requires a scene with keyframes or an animation: otherwise nothing moves");
        }
        return Optional.empty();
    }

    /**
     * What moves.
     *
     * @param scene to render, with what options have changed
     * @param film whether frames are rendered; a single picture does not follow keyframes unless it has a time
     */
    public Movement movement(Scene scene, MotionOptions physics, Optional<MotionFile> recorded, boolean film) {
        double secondsPerFrame = physics.secondsPerFrame();
        BodyMotion bodies = physics.isOn()
                ? new BodyMotion.Simulated(physics.startSeconds(), secondsPerFrame)
                : recorded.<BodyMotion>map(BodyMotion.Recorded::new).orElse(new BodyMotion.Still());
        DoubleFunction<Scene> single =
                seconds -> time.map(now -> Animation.at(scene, now + seconds)).orElse(scene);
        return new Movement(
                bodies,
                film ? seconds -> at(scene, seconds) : single,
                recorded.map(MotionFile::rate).orElse(1 / secondsPerFrame),
                film || physics.isOn() || time.isPresent() ? scene.rendering().shutter() : 0);
    }

    /** The settings with what {@code --shutter} says. */
    public Rendering over(Rendering usual) {
        return Ranges.over(usual, "--shutter", shutter, SceneProperties.SHUTTER);
    }

    private Scene at(Scene scene, double seconds) {
        return turntable
                .map(turn -> Animation.tracked(
                        scene.withCamera(CameraPath.onCircle(scene.camera(), scene.spheres(), seconds / turn)),
                        seconds))
                .orElseGet(() -> Animation.at(scene, seconds));
    }

    /** Rejects options that apply only to frames, or to what moves. */
    public void checkSingle(MotionOptions physics) {
        if (shutter.isPresent() && time.isEmpty() && !physics.isOn()) {
            throw new BadInputException("--shutter requires frames, --time or --physics: otherwise nothing moves");
        }
        if (overwrite || skipExisting) {
            throw new BadInputException((overwrite ? "--overwrite" : "--skip-existing")
                    + " requires --frames; a single picture always replaces its file");
        }
    }
}
