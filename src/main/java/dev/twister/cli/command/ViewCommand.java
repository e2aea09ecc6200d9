package dev.twister.cli.command;

import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.Home;
import dev.twister.cli.file.ModelFile;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.file.SceneOutput;
import dev.twister.cli.file.SkyFiles;
import dev.twister.cli.option.Completions;
import dev.twister.cli.option.ModelOptions;
import dev.twister.engine.Engines;
import dev.twister.gui.Gui;
import dev.twister.gui.files.ShippedFolders;
import dev.twister.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code twister view}: a mesh in the window. */
@Command(
        name = "view",
        description = "Opens a mesh in the window: on the checkered plane, scaled and framed, under the day sky.",
        footer = {
            "",
            "Examples:",
            "  twister view knot.obj",
            "  twister view scan.ply --up z --rotate 30",
            "  twister view model.glb -o model.json"
        })
final class ViewCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "FILE", description = "An OBJ, glTF, GLB, PLY or STL file.")
    private Path file;

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            completionCandidates = Completions.OfEngine.class,
            description =
                    "The engine to start with (see 'twister devices'). Default: the last one chosen in the window.")
    private Optional<String> engineId = Optional.empty();

    @Option(
            names = {"-o", "--output"},
            paramLabel = "SCENE",
            description = "Write the scene to this file, or to standard output with -, instead of opening the window.")
    private Optional<Path> output = Optional.empty();

    @Mixin
    private ModelOptions model;

    @Override
    public Integer call() throws IOException {
        Consumer<String> warnings = SkyFiles.warnings(spec.commandLine().getErr());
        ModelFile read = ModelFile.read(file, model.scene(), model.pose(), warnings);
        Scene scene = read.scene();
        if (output.isPresent()) {
            // For what is to be said of its textures.
            read.world(scene, warnings);
            if (SceneOutput.check(output.get())) {
                OutputFile.checkKeeps("--output", output.get(), List.of(file));
            }
            SceneOutput.write(scene, output.get(), spec.commandLine().getOut());
        } else {
            engineId.filter(id -> !Engines.isDevice(id))
                    .ifPresent(id -> Engines.offer(id).check());
            Gui.run(read.firstScene(file), engineId, new ShippedFolders(Home.scenes(), Home.skyboxes()));
        }
        return ExitCode.OK;
    }
}
