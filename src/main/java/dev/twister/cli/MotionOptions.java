package dev.twister.cli;

import dev.twister.physics.Simulation;
import java.io.PrintWriter;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Whether bodies move, and when they are looked at. */
final class MotionOptions {
    private static final int MAX_FRAMES = 1_000_000;
    private static final double MAX_RATE = 1000;
    private static final double MAX_START_SECONDS = 86_400;

    @Option(
            names = "--physics",
            description = "Let the bodies move as the scene's physics has it, and come what the scene pours.")
    private boolean physics;

    @Option(names = "--fps", paramLabel = "R", description = "Frames for each simulated second; 60 where not said.")
    private Optional<Double> rate = Optional.empty();

    @Option(
            names = "--start",
            paramLabel = "S",
            description = "Simulated seconds before the first frame; 0 where not said.")
    private Optional<Double> start = Optional.empty();

    boolean isOn() {
        return physics;
    }

    /** Refuses what makes no sense without motion. */
    void check() {
        check("--fps and --start", rate.isPresent() || start.isPresent());
    }

    /** The same where a number of frames is of the motion too. */
    void check(Optional<Integer> frames) {
        check("--frames, --fps and --start", rate.isPresent() || start.isPresent() || frames.isPresent());
        frames.ifPresent(count -> Ranges.check("--frames", count, 1, MAX_FRAMES));
    }

    private void check(String options, boolean given) {
        if (given && !physics) {
            throw new BadInputException(options + " go with --physics only: without it nothing moves");
        }
        secondsPerFrame();
        startSeconds();
    }

    double secondsPerFrame() {
        return 1 / checkRate(rate);
    }

    /** Frames a second. */
    static double checkRate(Optional<Double> rate) {
        return Ranges.check("--fps", rate.orElse(60.0), 1 / MAX_RATE, MAX_RATE);
    }

    double startSeconds() {
        return Ranges.check("--start", start.orElse(0.0), 0, MAX_START_SECONDS);
    }

    /** Lets the time before the first frame pass; for many bodies that takes minutes. */
    void begin(Simulation simulation, PrintWriter err) {
        int steps = Simulation.stepsIn(startSeconds());
        if (steps == 0) {
            return;
        }
        try (ProgressLine progress = ProgressLine.start(err, "moving to --start", steps)) {
            simulation.advance(startSeconds(), progress::step);
        }
    }
}
