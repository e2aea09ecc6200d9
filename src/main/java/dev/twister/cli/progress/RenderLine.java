package dev.twister.cli.progress;

import dev.twister.engine.ConvergingPicture.Convergence;
import dev.twister.files.PrintableText;
import dev.twister.render.FrameRange;
import dev.twister.render.RenderProgress;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import picocli.CommandLine;

/**
 * Shows the progress of {@code twister render}: the simulation before frame 0, frames, or parts of a single picture.
 */
public final class RenderLine implements RenderProgress, AutoCloseable {
    private static final int PERCENT = 100;

    private final CommandLine command;
    private final ProgressOptions options;
    private final Optional<FrameRange> frames;
    private Optional<ProgressLine> line = Optional.empty();
    private long start;

    public RenderLine(CommandLine command, ProgressOptions options, Optional<FrameRange> frames) {
        this.command = command;
        this.options = options;
        this.frames = frames;
    }

    @Override
    public void settling(int done, int all) {
        if (line.isEmpty()) {
            show(ProgressLine.start(command.getErr(), "moving to --start", all));
        }
        line.ifPresent(ProgressLine::step);
    }

    @Override
    public void begin() {
        start = System.nanoTime();
        close();
        frames.ifPresent(range -> show(options.start(command, "rendering", range.count())));
    }

    @Override
    public void part(String engine, double part, Optional<Convergence> pass) {
        if (frames.isEmpty()) {
            if (line.isEmpty()) {
                show(ProgressLine.start(command.getErr(), engine, PERCENT));
            }
            line.ifPresent(shown -> shown.stepTo((long) (PERCENT * part)));
            pass.ifPresent(reached -> line.ifPresent(shown -> shown.says(text(reached))));
            if (part == 1) {
                close();
            }
        }
    }

    private static String text(Convergence reached) {
        return String.format(Locale.ROOT, "%d samples, noise %.2g", reached.samples(), reached.noise());
    }

    @Override
    public void replacing(Path file, String why) {
        line.ifPresent(ProgressLine::clear);
        command.getErr()
                .println("twister: " + PrintableText.line(file.toString()) + " " + why + "; rendering it again");
    }

    @Override
    public void frame() {
        line.ifPresent(ProgressLine::step);
    }

    /** Time since the first picture began. */
    public long nanos() {
        return System.nanoTime() - start;
    }

    private void show(ProgressLine started) {
        close();
        line = Optional.of(started);
    }

    @Override
    public void close() {
        line.ifPresent(ProgressLine::close);
        line = Optional.empty();
    }
}
