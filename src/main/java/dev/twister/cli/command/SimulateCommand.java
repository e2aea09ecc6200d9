package dev.twister.cli.command;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.file.SceneFiles;
import dev.twister.cli.file.SkyFiles;
import dev.twister.cli.option.Completions;
import dev.twister.cli.option.FrameRangeConverter;
import dev.twister.cli.option.MotionOptions;
import dev.twister.cli.progress.ProgressLine;
import dev.twister.cli.progress.ProgressOptions;
import dev.twister.files.PrintableText;
import dev.twister.motion.MotionFile;
import dev.twister.motion.MotionFrame;
import dev.twister.motion.MotionRecording;
import dev.twister.motion.PointCache;
import dev.twister.physics.Simulation;
import dev.twister.render.FrameRange;
import dev.twister.render.SceneInputs;
import dev.twister.scene.Scene;
import dev.twister.scene.select.VisibleBodies;
import dev.twister.world.SceneMeshes;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code twister simulate}: from a scene to a motion file. */
@Command(
        name = "simulate",
        description = "Simulates a scene's bodies once and records their positions in a motion file, for"
                + " 'twister render --motion'.",
        footer = {
            "",
            "Run it again to resume: it keeps the frames that are complete and adds the missing ones.",
            "",
            "Examples:",
            "  twister simulate pour-1000 -o pour.motion --frames 600",
            "  twister simulate pour-100000 -o shot.motion --frames 0-5999 --fps 60",
            "  twister simulate pour-1000 -o pour.motion --frames 600 --export pc2"
        })
final class SimulateCommand implements Callable<Integer> {
    private static final String PC2 = "pc2";

    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "SCENE",
            completionCandidates = Completions.OfScene.class,
            description = "A scene file, the name of a shipped scene, or - for standard input.")
    private String sceneName;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "The motion file.")
    private Path output;

    @Option(
            names = "--frames",
            required = true,
            paramLabel = "RANGE",
            converter = FrameRangeConverter.class,
            description = "N: frames 0 to N-1; A-B: frames A to B. Frame n is at n / fps seconds.")
    private FrameRange frames;

    @Option(names = "--fps", paramLabel = "FPS", description = "Frames per simulated second (default: 60).")
    private Optional<Double> rate = Optional.empty();

    @Option(
            names = "--export",
            paramLabel = "FORMAT",
            description = "pc2: also write the spheres' centers to FILE.pc2, a point cache for Blender and 3ds Max.")
    private Optional<String> export = Optional.empty();

    @Mixin
    private ProgressOptions progress;

    @Override
    public Integer call() throws IOException {
        if (export.isPresent() && !export.get().equals(PC2)) {
            throw new BadInputException("unknown value '" + export.get() + "' of --export; expected: " + PC2);
        }
        double framesPerSecond = MotionOptions.checkRate(rate);
        Path file = SceneFiles.find(sceneName);
        Scene scene = VisibleBodies.of(SceneFiles.read(file));
        OutputFile.check("--output", output);
        OutputFile.checkKeeps("--output", output, SceneInputs.of(file, scene));
        int kept = record(scene, framesPerSecond);
        CommandLine command = spec.commandLine();
        OutputFile.notes(command, output)
                .printf(
                        "%s: frames %d to %d of %d bodies%s%n",
                        PrintableText.line(output.toString()),
                        frames.first(),
                        frames.last(),
                        scene.allSpheres().size(),
                        kept == 0 ? "" : ", %d kept".formatted(kept));
        if (export.isPresent()) {
            exportPoints(scene);
        }
        return ExitCode.OK;
    }

    /** Returns how many frames were there. */
    private int record(Scene scene, double framesPerSecond) throws IOException {
        try (MotionRecording recording = MotionRecording.open(output, scene, frames.first(), framesPerSecond)) {
            int kept = Math.min(recording.nextFrame() - frames.first(), frames.count());
            if (kept < frames.count()) {
                record(scene, recording, framesPerSecond);
            }
            return kept;
        }
    }

    // A simulation has no other way to a frame than by way of those before it.
    private void record(Scene scene, MotionRecording recording, double framesPerSecond) throws IOException {
        SceneMeshes meshes = SkyFiles.meshes(scene, spec.commandLine().getErr());
        try (Simulation simulation = Simulation.ofFilm(scene, meshes, 0);
                ProgressLine line = progress.start(spec.commandLine(), "simulating", frames.last() + 1L)) {
            for (int number = 0; number <= frames.last(); number++) {
                if (number >= recording.nextFrame() - 1 && number >= frames.first()) {
                    recording.put(
                            number, new MotionFrame(simulation.bodies(), simulation.positions(recording.origin())));
                }
                simulation.advance(1 / framesPerSecond);
                line.step();
            }
        }
    }

    private void exportPoints(Scene scene) throws IOException {
        Path points = output.resolveSibling(output.getFileName().toString().replaceFirst("\\.motion$", "") + "." + PC2);
        OutputFile.check("--export", points);
        try (MotionFile motion = MotionFile.open(output, scene)) {
            PointCache.write(points, motion, frames.first(), frames.last());
        }
        OutputFile.notes(spec.commandLine(), output)
                .printf("%s: a point cache of %d frames%n", PrintableText.line(points.toString()), frames.count());
    }
}
