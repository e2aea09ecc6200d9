package dev.twister.cli.command;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.bench.device.DeviceCheckPlan;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.FakeEngine;
import dev.twister.image.FrameTimes;
import dev.twister.image.PictureSize;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DeviceCheckingTest {
    private static final PictureSize SMALL = new PictureSize(16, 9);
    private static final DeviceCheckPlan PLAN = new DeviceCheckPlan(SMALL, SMALL, 0, 1, 1);

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    @TempDir
    private Path folder;

    @Test
    void printsARowForEachEngineAndWritesJson() throws IOException {
        Path json = folder.resolve("check.json");

        assertThat(check(List.of(Engines.offer("parallel"), Engines.offer("sequential")), Optional.of(json)))
                .isTrue();

        assertThat(out.toString())
                .contains(
                        "benchmark, bokeh, cornell, gallery, glass",
                        "\n| parallel ",
                        "\n| sequential ",
                        "within tolerance");
        assertThat(err.toString()).isEmpty();
        assertThat(json).isNotEmptyFile();
    }

    @Test
    void aWrongPictureFails() throws IOException {
        EngineOffer wrong = EngineOffer.working(
                "wrong", "a card", "of the test's", () -> new FakeEngine("wrong", 0, FrameTimes.onJvm(1)));

        assertThat(check(List.of(wrong), Optional.empty())).isFalse();

        assertThat(out.toString()).contains("WRONG: ", "benchmark 144 of 144");
    }

    private boolean check(List<EngineOffer> offers, Optional<Path> json) throws IOException {
        return new DeviceChecking(PLAN, new PrintWriter(out, true), new PrintWriter(err, true)).run(offers, json);
    }
}
