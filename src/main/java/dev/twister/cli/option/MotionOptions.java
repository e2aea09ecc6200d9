package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Options for physics and the time of frames. */
public final class MotionOptions {
    private static final double MAX_RATE = 1000;
    private static final double MAX_START_SECONDS = 86_400;

    @Option(names = "--physics", description = "Simulate physics, including poured spheres.")
    private boolean physics;

    @Option(
            names = "--fps",
            paramLabel = "FPS",
            description = "Frames per second, of the film or of the simulation (default: 60).")
    private Optional<Double> rate = Optional.empty();

    @Option(
            names = "--start",
            paramLabel = "SECONDS",
            description = "Simulated seconds before the first frame (default: 0).")
    private Optional<Double> start = Optional.empty();

    public boolean isOn() {
        return physics;
    }

    /** Rejects options that apply only to moving bodies. */
    public void check() {
        if (isTimeGiven() && !physics) {
            throw new BadInputException("--fps and --start require --physics: without it nothing moves");
        }
        secondsPerFrame();
        startSeconds();
    }

    boolean isTimeGiven() {
        return rate.isPresent() || start.isPresent();
    }

    boolean isStartGiven() {
        return start.isPresent();
    }

    /** Rejects {@code --start} if only the camera moves. */
    void checkStart() {
        if (start.isPresent() && !physics) {
            throw new BadInputException("--start requires --physics; use --frames to begin a film later");
        }
        secondsPerFrame();
        startSeconds();
    }

    public double secondsPerFrame() {
        return 1 / checkRate(rate);
    }

    /** Frames per second. */
    public static double checkRate(Optional<Double> rate) {
        return Ranges.check("--fps", rate.orElse(60.0), 1 / MAX_RATE, MAX_RATE);
    }

    public double startSeconds() {
        return Ranges.check("--start", start.orElse(0.0), 0, MAX_START_SECONDS);
    }
}
