package dev.twister.cli;

import dev.twister.render.RenderProgress;
import java.io.PrintWriter;
import java.util.Optional;

/** Shows how many bands of a picture are drawn, and of the next picture after it. */
final class BandLine implements RenderProgress, AutoCloseable {
    private final PrintWriter err;
    private Optional<ProgressLine> line = Optional.empty();

    BandLine(PrintWriter err) {
        this.err = err;
    }

    @Override
    public void bands(String engine, int done, int all) {
        if (done == 0) {
            close();
            line = Optional.of(ProgressLine.start(err, engine, all));
        } else {
            line.ifPresent(shown -> shown.stepTo(done));
        }
        if (done == all) {
            close();
        }
    }

    @Override
    public void close() {
        line.ifPresent(ProgressLine::close);
        line = Optional.empty();
    }
}
