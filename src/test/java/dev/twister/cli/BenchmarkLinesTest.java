package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.bench.Benchmark;
import dev.twister.bench.BenchmarkPlan;
import dev.twister.bench.BenchmarkReport;
import dev.twister.bench.MachineInfo;
import dev.twister.bench.PictureSize;
import dev.twister.engine.Engines;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneReader;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.World;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class BenchmarkLinesTest {
    private static final PictureSize SIZE = new PictureSize(5, 3);

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();
    private final BenchmarkPlan plan =
            new BenchmarkPlan(List.of("sequential", "parallel"), List.of(SIZE), 1, 0, 0, 1, 10);

    @Test
    void anEndBeforeAnythingIsMeasuredSaysWhere() {
        try (BenchmarkLines lines = lines()) {
            lines.begins("parallel", SIZE, 1);
            lines.giveUp();
        }

        assertThat(err.toString()).contains("ended at parallel 5x3", "nothing was measured");
        assertThat(out.toString()).isEmpty();
    }

    @Test
    void anEndAfterThatLosesNothing() {
        try (BenchmarkLines lines = lines()) {
            Benchmark.run(Engines::open, plan, "benchmark", world(), Optional.empty(), lines);
            lines.begins("tornado:0:0", SIZE, 1);
            lines.giveUp();
        }

        assertThat(err.toString()).contains("ended at tornado:0:0 5x3");
        assertThat(out.toString()).containsPattern("sequential .* 5x3 ").containsPattern("parallel .* 5x3 ");
    }

    @Test
    void anEndInTimeSaysNothing() {
        try (BenchmarkLines lines = lines()) {
            Benchmark.run(Engines::open, plan, "benchmark", world(), Optional.empty(), lines);
        }

        assertThat(err.toString()).isEmpty();
        assertThat(out.toString()).isEmpty();
    }

    private BenchmarkLines lines() {
        return new BenchmarkLines(
                new PrintWriter(out),
                new PrintWriter(err),
                measured -> new BenchmarkReport(MachineInfo.ofThisMachine(), plan, "benchmark", measured, List.of()));
    }

    private static World world() {
        Scene scene = SceneReader.read(SceneFiles.find("benchmark"));
        return World.of(scene, SkyboxReader.read(scene.skybox()));
    }
}
