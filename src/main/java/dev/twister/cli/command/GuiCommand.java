package dev.twister.cli.command;

import dev.twister.bench.report.WindowRates;
import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.Home;
import dev.twister.cli.file.ModelFile;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.file.SceneFiles;
import dev.twister.cli.file.SkyFiles;
import dev.twister.cli.option.Completions;
import dev.twister.cli.option.ModelOptions;
import dev.twister.engine.Engines;
import dev.twister.gui.Gui;
import dev.twister.gui.Gui.FirstScene;
import dev.twister.gui.files.ShippedFolders;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.scene.SceneException;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code twister gui}: the window. */
@Command(
        name = "gui",
        description = "Opens the window, as 'twister' without a command does.",
        footer = {
            "",
            "Examples:",
            "  twister gui mirrors",
            "  twister gui my-scene.json --engine vector",
            "  twister gui benchmark --engine vector --measure window.json"
        })
final class GuiCommand implements Callable<Integer> {
    static final String FIRST_SCENE = "weekend";

    @Parameters(
            paramLabel = "SCENE",
            completionCandidates = Completions.OfScene.class,
            arity = "0..1",
            description = "A scene file, the name of a shipped scene, a mesh file, or a panorama to see a scene under. "
                    + "Default: " + FIRST_SCENE + ".")
    private Optional<String> sceneName = Optional.empty();

    @Spec
    private CommandSpec spec;

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            completionCandidates = Completions.OfEngine.class,
            description =
                    "The engine to start with (see 'twister devices'). Default: the last one chosen in the window,"
                            + " or auto.")
    private Optional<String> engineId = Optional.empty();

    @Option(
            names = "--measure",
            paramLabel = "FILE",
            description =
                    "Move the camera around the scene at 720p, write the frames per second of 10 s and the display"
                            + " to FILE as JSON, and close the window. A .jsonl file gets them as a new line.")
    private Optional<Path> measurement = Optional.empty();

    @Override
    public Integer call() throws IOException {
        Path asked = SceneFiles.find(sceneName.orElse(FIRST_SCENE));
        Optional<Path> panorama = Optional.of(asked).filter(Gui::isPanorama);
        Path file = panorama.isPresent() ? SceneFiles.find(FIRST_SCENE) : asked;
        // To look for devices takes TornadoVM a second: the window tells of one that is not there.
        engineId.filter(id -> !Engines.isDevice(id))
                .ifPresent(id -> Engines.offer(id).check());
        FirstScene first = panorama.map(sky -> FirstScene.of(OpenedScene.readUnder(sky, file)))
                .orElseGet(() -> ModelFile.isNamed(file) ? staged(file) : first(file));
        ShippedFolders shipped = new ShippedFolders(Home.scenes(), Home.skyboxes());
        if (measurement.isPresent()) {
            return measure(first, shipped, measurement.get());
        }
        Gui.run(first, engineId, shipped);
        return ExitCode.OK;
    }

    private int measure(FirstScene first, ShippedFolders shipped, Path file) throws IOException {
        OutputFile.check("--measure", file);
        Optional<WindowRates> rates = Gui.measure(first, engineId, shipped);
        if (rates.isEmpty()) {
            throw new BadInputException(
                    "the window was closed early, the engine did not start within 60 s, or fewer than two pictures were"
                            + " shown in 10 s; take a faster --engine");
        }
        rates.get().write(sceneName.orElse(FIRST_SCENE), file);
        OutputFile.notes(spec.commandLine(), file)
                .println(OutputFile.name(file) + ": " + rates.get().text());
        return ExitCode.OK;
    }

    /** A mesh as 'twister view' shows it. */
    private FirstScene staged(Path mesh) {
        PrintWriter err = spec.commandLine().getErr();
        ModelOptions options = new ModelOptions();
        return ModelFile.read(mesh, options.scene(), options.pose(), SkyFiles.warnings(err))
                .firstScene(mesh);
    }

    /** The window says what is wrong with a file that is there: nobody sees the last line of a double click. */
    private FirstScene first(Path file) {
        try {
            return new FirstScene(OpenedScene.read(file), sceneName.isPresent(), Optional.empty());
        } catch (SceneException problem) {
            if (sceneName.isEmpty() || !Files.isRegularFile(file)) {
                throw problem;
            }
            return new FirstScene(OpenedScene.read(SceneFiles.find(FIRST_SCENE)), false, Optional.of(file));
        }
    }
}
