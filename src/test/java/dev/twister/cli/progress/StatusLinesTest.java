package dev.twister.cli.progress;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class StatusLinesTest {
    private final StringWriter out = new StringWriter();
    private final AtomicLong clock = new AtomicLong();
    private final StatusLines lines = new StatusLines(new PrintWriter(out), "rendering", 400, clock::get);

    @Test
    void tellsProgressAndTheTimeLeftOnceASecond() {
        for (int step = 0; step < 4; step++) {
            clock.addAndGet(TimeUnit.MILLISECONDS.toNanos(500));
            lines.step();
        }

        assertThat(out.toString().lines())
                .containsExactly(
                        "openjd_progress: 0.5",
                        "openjd_status: rendering: 2 of 400, 3 min 19 s left",
                        "openjd_progress: 1.0",
                        "openjd_status: rendering: 4 of 400, 3 min 18 s left");
    }

    @Test
    void tellsTheEndAtOnce() {
        lines.stepTo(400);

        assertThat(out.toString().lines())
                .containsExactly("openjd_progress: 100.0", "openjd_status: rendering: 400 of 400, 0 s left");
    }
}
