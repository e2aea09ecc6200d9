package dev.twister.cli;

import dev.twister.bench.FastestEngine;
import dev.twister.bench.PictureSize;
import dev.twister.bench.StartUp;
import dev.twister.bench.StartUpReport;
import dev.twister.engine.Engines;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneReader;
import dev.twister.world.World;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code twister start-up}: how soon this very process draws, and draws fast. */
@Command(
        name = "start-up",
        description = "Measures its own cold start: when the first frame was there, and when nine tenths of full speed"
                + " were reached, in milliseconds since the JVM began.",
        footer = {"", "Examples:", "  twister start-up", "  twister start-up spheres-100 --engine vector --size 1080p"})
final class StartUpCommand implements Runnable {
    private static final double NANOS_PER_MILLI = 1e6;
    private static final int MAX_SECONDS = 3600;

    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "SCENE",
            completionCandidates = Completions.OfScene.class,
            arity = "0..1",
            defaultValue = "benchmark",
            description = "A scene file, or the name of a shipped scene; ${DEFAULT-VALUE} where not said.")
    private String sceneName;

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            completionCandidates = Completions.OfEngine.class,
            defaultValue = FastestEngine.AUTO,
            description = "What draws (see 'twister devices'); ${DEFAULT-VALUE} where not said.")
    private String engineId;

    @Option(
            names = "--size",
            paramLabel = "SIZE",
            converter = PictureSizeConverter.class,
            defaultValue = "720p",
            description = "Such as 1280x720, or 720p, 1080p, 4k; ${DEFAULT-VALUE} where not said.")
    private PictureSize size;

    @Option(
            names = "--seconds",
            paramLabel = "S",
            defaultValue = "15",
            description = "How long to draw, in seconds since the JVM began; ${DEFAULT-VALUE} where not said.")
    private int seconds;

    @Override
    public void run() {
        Ranges.check("--seconds", seconds, 1, MAX_SECONDS);
        Scene scene = SceneReader.read(SceneFiles.find(sceneName));
        World world =
                World.of(scene, SkyFiles.read(scene.skybox(), spec.commandLine().getErr()));
        world.setSettings(world.settings().withSize(size.width(), size.height()));
        try (ProgressLine line = ProgressLine.start(spec.commandLine().getErr(), engineId, seconds)) {
            print(new StartUp(StartUpCommand::nanosSinceStart)
                    .run(
                            () -> Engines.open(engineId),
                            world.snapshot(),
                            Duration.ofSeconds(seconds),
                            () -> line.stepTo(
                                    Duration.ofNanos(nanosSinceStart()).toSeconds())));
        }
    }

    private void print(StartUpReport report) {
        spec.commandLine()
                .getOut()
                .printf(
                        Locale.ROOT,
                        "%s at %s, since the JVM began:%n"
                                + "  first frame, by %s: %d ms%n"
                                + "  nine tenths of full speed: %d ms%n"
                                + "  full speed, by %s: %.1f ms a frame (%d frames drawn)%n",
                        sceneName,
                        size,
                        report.firstEngine(),
                        report.firstFrame().toMillis(),
                        report.fullSpeed().toMillis(),
                        report.lastEngine(),
                        report.fullFrame().toNanos() / NANOS_PER_MILLI,
                        report.frames());
    }

    private static long nanosSinceStart() {
        long startMillis = ManagementFactory.getRuntimeMXBean().getStartTime();
        return Duration.ofMillis(System.currentTimeMillis() - startMillis).toNanos();
    }
}
