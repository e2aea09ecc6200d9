package dev.twister.bench.device;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.bench.TestWorld;
import dev.twister.bench.benchmark.BenchmarkProgress;
import dev.twister.bench.device.CheckedEngine.CheckedPicture;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.FakeEngine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.image.PictureSize;
import dev.twister.scene.generate.SceneGenerator;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class DeviceCheckTest {
    private static final DeviceCheckPlan PLAN =
            new DeviceCheckPlan(new PictureSize(8, 5), new PictureSize(9, 4), 0, 1, 100);
    private static final CheckedScene SCENE = new CheckedScene("few", TestWorld.create());
    private static final DeviceCheck CHECK = new DeviceCheck(
            PLAN,
            List.of(SCENE, new CheckedScene("other", TestWorld.create())),
            new CheckedScene("timed", SCENE.world()));

    private static final EngineOffer DEVICE = offer("tornado:9:9", Device::new).withDriver("1.2|3");
    private static final EngineOffer WRONG =
            offer("wrong", () -> new FakeEngine("wrong", 0xff808080, FrameTimes.onJvm(1)));
    private static final EngineOffer BROKEN = offer("broken", () -> {
        throw new EngineException("out of\norder");
    });
    private static final EngineOffer IMPOSSIBLE =
            EngineOffer.impossible("missing", "a card", "none", "install a driver");

    @TempDir
    private Path folder;

    /** Renders correctly; its first frame takes half a second. */
    private record Device(Engine engine, AtomicInteger frames) implements Engine {
        Device() {
            this(Engines.open("sequential"), new AtomicInteger());
        }

        @Override
        public String id() {
            return "tornado:9:9";
        }

        @Override
        public String device() {
            return "a card";
        }

        @Override
        public void render(FrameInput input, Frame frame) {
            engine.render(input, frame);
            long compiling = frames.getAndIncrement() == 0 ? 500_000_000 : 0;
            frame.setTimes(new FrameTimes(10_000_000 + compiling, 7_000_000, 2_000_000, 1_000_000));
        }

        @Override
        public void close() {
            engine.close();
        }
    }

    private static EngineOffer offer(String id, Supplier<Engine> opener) {
        return EngineOffer.working(id, "a card", "of the test's", opener);
    }

    private static CheckedEngine check(EngineOffer offer) {
        return CHECK.check(offer, BenchmarkProgress.SILENT);
    }

    private static String row(CheckedEngine checked) {
        return new DeviceCheckTable(PLAN, List.of(DEVICE, WRONG, BROKEN, IMPOSSIBLE)).row(checked);
    }

    @Test
    void aDeviceIsComparedInEverySceneAndTimed() {
        CheckedEngine checked = check(DEVICE);

        assertThat(checked.passed()).isTrue();
        assertThat(checked.compileSeconds()).contains(0.5);
        assertThat(checked.scenes()).extracting(CheckedPicture::name).containsExactly("few", "other");
        assertThat(row(checked))
                .isEqualTo(
                        "| tornado:9:9 | a card | 1.2\\|3 |        0.5 |   7.00 |     7.00 |       2.00 |        1.00 |"
                                + " within tolerance: 0 of 152 pixels off |");
    }

    @Test
    void anEngineOfTheJvmHasNoCompilerAndNoCopies() {
        CheckedEngine checked = check(Engines.offer("parallel"));

        assertThat(checked.passed()).isTrue();
        assertThat(checked.compileSeconds()).isEmpty();
        assertThat(row(checked)).contains("| - ", "within tolerance");
    }

    /** Other scenes, whose kernels take more or less time, may come and go. */
    @Test
    void compilingIsMeasuredInTheTimedScene() {
        List<Integer> bodies = new ArrayList<>();
        World timed = World.of(SceneGenerator.spheres(7, 1, Path.of("sky.hdr")), new Skybox(1, 1, new float[3]));
        int count = timed.snapshot().bodyCount();
        CheckedScene scene = new CheckedScene("timed", timed);

        new DeviceCheck(PLAN, List.of(SCENE, scene), scene)
                .check(offer("tornado:9:9", () -> new Listening(new Device(), bodies)), BenchmarkProgress.SILENT);

        assertThat(bodies).startsWith(count, count, SCENE.world().snapshot().bodyCount(), count);
    }

    /** Tells how many bodies its frames have. */
    private record Listening(Engine engine, List<Integer> bodies) implements Engine {
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
            bodies.add(input.bodyCount());
            engine.render(input, frame);
        }

        @Override
        public void close() {
            engine.close();
        }
    }

    @Test
    void settingsOfWhatIsTimedAreNotThoseOfTheNextEnginesPictures() {
        check(DEVICE);

        assertThat(check(DEVICE).passed()).isTrue();
    }

    @Test
    void anotherPictureIsNamed() {
        CheckedEngine checked = check(WRONG);

        assertThat(checked.passed()).isFalse();
        assertThat(row(checked))
                .contains(
                        "WRONG: few 40 of 40 (0 may), other 40 of 40 (0 may)",
                        "timed 9x4, 1 shadow sample, 1 bounce 36 of 36 (0 may)");
    }

    @Test
    void aFailureIsInItsRow() {
        CheckedEngine checked = check(BROKEN);

        assertThat(checked.passed()).isFalse();
        assertThat(row(checked)).startsWith("| broken ").endsWith("| FAILED: out of order |");
    }

    @Test
    void whatDoesNotWorkHereIsNoFailure() {
        CheckedEngine checked = check(IMPOSSIBLE);

        assertThat(checked.passed()).isTrue();
        assertThat(row(checked)).endsWith("| does not work here: install a driver |");
    }

    @Test
    void headingIsATableOfMarkdown() {
        List<String> lines = new DeviceCheckTable(PLAN, List.of(DEVICE))
                .heading(List.of(SCENE), SCENE)
                .lines()
                .toList();

        assertThat(lines.get(1)).startsWith("- Twister ").contains("JDK " + Runtime.version());
        assertThat(lines.get(2)).endsWith("pictures at 8x5 beside sequential's: few");
        assertThat(lines.get(5)).startsWith("| engine      | device | driver | compiles s | 1/1 ms |");
        assertThat(lines.get(6))
                .startsWith("| ----------- | ------ | ------ | ---------: | -----: |")
                .hasSameSizeAs(lines.get(5));
    }

    @Test
    void jsonHasEveryFact() throws IOException {
        Path file = folder.resolve("check.json");
        DeviceCheckJson.write(PLAN, List.of(check(DEVICE), check(BROKEN)), file);

        JsonNode check = JsonMapper.builder().build().readTree(Files.readString(file));
        assertThat(check.at("/machine/jit").asString()).isNotEmpty();
        assertThat(check.at("/pictureSize").asString()).isEqualTo("8x5");
        assertThat(check.at("/passed").asBoolean()).isFalse();
        JsonNode device = check.at("/engines/0");
        assertThat(device.at("/driver").asString()).isEqualTo("1.2|3");
        assertThat(device.at("/compileSeconds").asDouble()).isEqualTo(0.5);
        assertThat(device.at("/pictures/1/scene").asString()).isEqualTo("other");
        assertThat(device.at("/pictures/1/differingPixels").asInt(-1)).isZero();
        assertThat(device.at("/results/1/shadowSamples").asInt()).isEqualTo(200);
        assertThat(device.at("/results/1/msKernel").asDouble()).isEqualTo(7);
        assertThat(check.at("/engines/1/failure").asString()).isEqualTo("out of\norder");
    }
}
