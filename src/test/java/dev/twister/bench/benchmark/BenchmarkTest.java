package dev.twister.bench.benchmark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import dev.twister.bench.GreedyEngine;
import dev.twister.bench.Statistics;
import dev.twister.bench.TestWorld;
import dev.twister.bench.benchmark.Measurement.DeviceTimes;
import dev.twister.bench.benchmark.Measurement.MotionTimes;
import dev.twister.bench.report.ReportFields;
import dev.twister.bench.report.ReportTable;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.Engines;
import dev.twister.engine.FakeEngine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.image.PictureSize;
import dev.twister.physics.Simulation;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Pour;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

public class BenchmarkTest {
    private static final PictureSize SMALL = new PictureSize(5, 3);
    private static final PictureSize LARGE = new PictureSize(9, 4);
    private static final int GRAY = 0xff808080;
    private static final double START = 0.5;
    private static final Scene POURED = TestWorld.scene()
            .withPour(Pour.DEFAULT
                    .withCount(40)
                    .withRate(20)
                    .withPosition(new Vector3(0, 30, 0))
                    .withWidth(3.5)
                    .withSpeed(3)
                    .withRadii(0.07, 0.13));

    @Test
    void measuresEveryEngineAtEverySize() {
        BenchmarkReport report = run(plan(List.of("sequential", "parallel"), 2, 4, 1000));

        assertThat(report.passed()).isTrue();
        assertThat(report.measurements())
                .extracting(
                        Measurement::engine,
                        measurement -> measurement.setting().size())
                .containsExactly(
                        tuple("sequential", SMALL),
                        tuple("parallel", SMALL),
                        tuple("sequential", LARGE),
                        tuple("parallel", LARGE));
        assertThat(report.measurements()).allSatisfy(measurement -> {
            assertThat(measurement.warmupFrames()).isEqualTo(2);
            assertThat(measurement.times().frames()).isEqualTo(4);
            assertThat(measurement.setting().shadowSamples()).isEqualTo(7);
            assertThat(measurement.setting().bounces()).isEqualTo(2);
            assertThat(measurement.bodies()).isEqualTo(5);
            assertThat(measurement.deviceTimes()).isEmpty();
        });
    }

    @Test
    void speedupsAreOverTheSameSize() {
        BenchmarkReport report = run(plan(List.of("sequential", "parallel", "other"), 0, 1, 1000));

        Measurement other = report.measurements().get(5);
        assertThat(other.setting().size()).isEqualTo(LARGE);
        assertThat(report.speedupOver("sequential", other)).contains(4.0);
        assertThat(report.speedupOver("parallel", other)).contains(2.0);
        assertThat(report.speedupOver("missing", other)).isEmpty();
    }

    /** And those in which a device tries work-groups. */
    @ParameterizedTest
    @CsvSource({"sequential, 1", "tornado:0:0, 6"})
    void shortTimeStillTakesAFrameOfEach(String engine, int warmups) {
        Measurement measurement =
                run(plan(List.of(engine), 100, 100, 1e-9)).measurements().getFirst();

        assertThat(measurement.warmupFrames()).isEqualTo(warmups);
        assertThat(measurement.times().frames()).isEqualTo(1);
    }

    @Test
    void anotherPictureFails() {
        BenchmarkReport report = run(plan(List.of("wrong"), 0, 1, 1000));

        assertThat(report.passed()).isFalse();
        assertThat(report.measurements().getFirst().comparison()).isEqualTo(new PictureComparison(15, 15, 2));
        assertThat(ReportTable.of(report)).contains("FAILED: wrong at 5x3", "15 of 15 pixels");
    }

    @Test
    void anEngineThatFailsDoesNotStopTheOthers() {
        BenchmarkReport report = run(plan(List.of("broken", "sequential"), 0, 1, 1000));

        assertThat(report.passed()).isFalse();
        assertThat(report.failures()).containsExactly(new EngineFailure("broken", "out of order"));
        assertThat(report.measurements()).extracting(Measurement::engine).containsOnly("sequential");
    }

    @Test
    void anEngineThatBecomesAnotherIsMeasuredUnderItsName() {
        BenchmarkReport report = run(plan(List.of("becomes parallel", "sequential", "parallel"), 1, 1, 1000));

        Measurement measurement = report.measurements().getFirst();
        assertThat(measurement.engine()).isEqualTo("becomes parallel");
        assertThat(measurement.device()).isEqualTo("parallel: a device of the test's");
        assertThat(runMoving("becomes parallel", 1, new ArrayList<>()))
                .extracting(Measurement::engine, Measurement::device)
                .containsExactly(measurement.engine(), measurement.device());
        assertThat(report.measurements().get(2).device()).isEqualTo("a device of the test's");
        assertThat(report.speedupOver("parallel", measurement)).contains(1.0);
    }

    @Test
    void anEngineThatNeedsTooMuchMemoryDoesNotStopTheOthers() {
        BenchmarkReport report = run(plan(List.of("greedy", "sequential"), 0, 1, 1000));

        assertThat(report.failures()).containsExactly(new EngineFailure("greedy", EngineFailure.outOfMemory()));
        assertThat(report.measurements())
                .extracting(
                        Measurement::engine,
                        measurement -> measurement.setting().size())
                .containsExactly(tuple("greedy", SMALL), tuple("sequential", SMALL), tuple("sequential", LARGE));
    }

    @Test
    void aDevicesTimesAreMeans() {
        BenchmarkReport report = run(plan(List.of("device"), 0, 2, 1000));

        assertThat(report.measurements().getFirst().deviceTimes()).isEqualTo(Optional.of(new DeviceTimes(6, 1, 3)));
    }

    @Test
    void tellsWhatItDoes() {
        List<String> heard = new ArrayList<>();
        Benchmark.run(
                BenchmarkTest::open,
                plan(List.of("sequential"), 1, 1, 100),
                "test",
                TestWorld.create(),
                Optional.empty(),
                new BenchmarkProgress() {
                    @Override
                    public void begins(String engine, PictureSize size, int frames) {
                        heard.add(engine + " " + size + " " + frames);
                    }

                    @Override
                    public void drewFrame() {
                        heard.add("frame");
                    }

                    @Override
                    public void found(BenchmarkReport soFar) {
                        heard.add("found "
                                + soFar.measurements().getLast().setting().size());
                    }
                });

        assertThat(heard)
                .containsExactly(
                        "reference 5x3 1",
                        "frame",
                        "reference 9x4 1",
                        "frame",
                        "sequential, warming up, 5x3 1",
                        "frame",
                        "sequential 5x3 2",
                        "frame",
                        "frame",
                        "found 5x3",
                        "sequential 9x4 2",
                        "frame",
                        "frame",
                        "found 9x4");
    }

    @Test
    void theRealEnginesAgree() {
        BenchmarkReport report = Benchmark.run(
                Engines::open,
                plan(List.of("sequential", "parallel"), 0, 1, 100),
                "test",
                TestWorld.create(),
                Optional.empty(),
                BenchmarkProgress.SILENT);

        assertThat(report.passed()).isTrue();
    }

    public static BenchmarkPlan plan(List<String> engines, int warmup, int frames, double seconds) {
        return BenchmarkPlan.bySize(
                engines, List.of(new Setting(SMALL, 7, 2), new Setting(LARGE, 7, 2)), warmup, frames, seconds);
    }

    @Test
    void movesTheBodiesForEachFrame() {
        MotionPlan motion = new MotionPlan(TestWorld.scene(), 0.1, 1.0 / 60);
        BenchmarkReport report = Benchmark.run(
                BenchmarkTest::open,
                plan(List.of("sequential", "parallel"), 2, 4, 100),
                "test",
                TestWorld.create(),
                Optional.of(motion),
                BenchmarkProgress.SILENT);

        assertThat(report.passed()).isTrue();
        assertThat(report.measurements()).hasSize(4).allSatisfy(measurement -> {
            assertThat(measurement.times().frames()).isEqualTo(4);
            MotionTimes times = measurement.motionTimes().orElseThrow();
            assertThat(times.step()).isPositive();
            assertThat(times.rebuild()).isPositive();
        });
        assertThat(ReportTable.of(report)).contains("step ms", "rebuild ms");
        assertThat(ReportFields.ofMeasurement(report, report.measurements().getFirst()))
                .containsKeys("msStep", "msRebuild");
    }

    @Test
    void warmsUpOnTheBodiesAsTheyAreAtTheStart() {
        List<String> heard = new ArrayList<>();
        runMoving("sequential", 1, heard);

        assertThat(heard)
                .containsExactly(
                        "sequential, moving to its start, 5x3 60",
                        "sequential, warming up, 5x3 1",
                        "drew the start",
                        "sequential 5x3 2",
                        "drew the start",
                        "drew later",
                        "sequential, moving to its start, 9x4 60",
                        "sequential 9x4 2",
                        "drew the start",
                        "drew later");
    }

    @Test
    void measuresTheSameBodiesHoweverLongTheWarmUp() {
        List<String> heard = new ArrayList<>();
        assertThat(runMoving("sequential", 6, heard).bodies())
                .isEqualTo(runMoving("sequential", 0, heard).bodies());
    }

    @Test
    void comparesTheSameFramesOfBodiesThatMove() {
        BenchmarkReport report = new BenchmarkReport(
                MachineInfo.ofThisMachine(),
                plan(List.of("sequential", "other"), 0, 3, 100),
                "test",
                List.of(moving("sequential", 40, 60), moving("other", 10, 15, 200)),
                List.of(),
                Map.of(),
                true);

        assertThat(report.speedupOver("sequential", report.measurements().getLast()))
                .contains(4.0);
    }

    private static Measurement moving(String engine, double... millis) {
        Statistics times = Statistics.ofNanos(
                Arrays.stream(millis).mapToLong(time -> (long) (time * 1e6)).toArray());
        List<Double> drawing = Arrays.stream(millis).boxed().toList();
        return new Measurement(
                engine,
                "a device of the test's",
                new Setting(SMALL, 7, 2),
                5,
                0,
                times,
                Optional.empty(),
                new PictureComparison(15, 0, 0),
                Optional.of(new MotionTimes(1, 1, drawing)));
    }

    @Test
    void movesWithoutWarmUpWhereNoneIsWanted() {
        List<String> heard = new ArrayList<>();
        runMoving("sequential", 0, heard);

        assertThat(heard).doesNotContain("sequential, warming up, 5x3 1", "drew the start");
    }

    private static Measurement runMoving(String engine, int warmup, List<String> heard) {
        BenchmarkReport report = Benchmark.run(
                id -> new StartTeller(open(id), atStart(), heard),
                plan(List.of(engine), warmup, 1, 100),
                "test",
                poured(),
                Optional.of(new MotionPlan(POURED, START, 1.0 / 60)),
                new BenchmarkProgress() {
                    @Override
                    public void begins(String engine, PictureSize size, int frames) {
                        heard.add(engine + " " + size + " " + frames);
                    }
                });
        return report.measurements().getLast();
    }

    private static FrameInput atStart() {
        World world = poured();
        try (Simulation simulation = Simulation.of(POURED)) {
            simulation.advance(START);
            simulation.place(world);
        }
        return world.snapshot();
    }

    private static World poured() {
        return World.of(POURED, new Skybox(1, 1, new float[] {0.2f, 0.4f, 0.8f}));
    }

    /** Records which start state its frames show (at rest or later), once per run of equal frames. */
    private record StartTeller(Engine engine, FrameInput start, List<String> heard) implements Engine {
        @Override
        public String id() {
            return engine.id();
        }

        @Override
        public String device() {
            return engine.device();
        }

        @Override
        public void render(FrameInput input, Frame frame) {
            String drew =
                    Arrays.equals(start.bodies().floats(), input.bodies().floats()) ? "drew the start" : "drew later";
            if (!heard.getLast().equals(drew)) {
                heard.add(drew);
            }
            engine.render(input, frame);
        }

        @Override
        public void close() {
            engine.close();
        }
    }

    public static BenchmarkReport run(BenchmarkPlan plan) {
        return Benchmark.run(
                BenchmarkTest::open, plan, "test", TestWorld.create(), Optional.empty(), BenchmarkProgress.SILENT);
    }

    private static Engine open(String id) {
        return switch (id) {
            case "sequential" -> new FakeEngine(id, GRAY, FrameTimes.onJvm(8_000_000));
            case "parallel", "becomes parallel" -> new FakeEngine("parallel", GRAY, FrameTimes.onJvm(4_000_000));
            case "other" -> new FakeEngine(id, GRAY, FrameTimes.onJvm(2_000_000));
            case "wrong" -> new FakeEngine(id, GRAY + 2, FrameTimes.onJvm(1_000_000));
            case "device", "tornado:0:0" ->
                new FakeEngine(id, GRAY, new FrameTimes(11_000_000, 6_000_000, 1_000_000, 3_000_000));
            case "greedy" -> new GreedyEngine(open("sequential"), id, LARGE.width());
            default -> throw new EngineException("out of order");
        };
    }
}
