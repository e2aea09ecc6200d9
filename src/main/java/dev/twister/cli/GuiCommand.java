package dev.twister.cli;

import dev.twister.bench.FastestEngine;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.gui.Gui;
import dev.twister.gui.GuiOptions;
import dev.twister.scene.SceneReader;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code twister gui}: the window. */
@Command(
        name = "gui",
        description = "Opens the window; 'twister' alone does too.",
        footer = {"", "Examples:", "  twister gui mirrors", "  twister gui my-scene.json --engine vector"})
final class GuiCommand implements Callable<Integer> {
    static final String FIRST_SCENE = "benchmark";

    @Parameters(
            paramLabel = "SCENE",
            arity = "0..1",
            defaultValue = FIRST_SCENE,
            description = "A scene file, or the name of a shipped scene; ${DEFAULT-VALUE} where not said.")
    private String sceneName = FIRST_SCENE;

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            defaultValue = FastestEngine.AUTO,
            description = "What draws at first (see 'twister devices'); ${DEFAULT-VALUE} where not said.")
    private String engineId = FastestEngine.AUTO;

    @Override
    public Integer call() {
        Path file = SceneFiles.find(sceneName);
        // Looking for engines takes TornadoVM a second: that is left to the thread that opens this one.
        EngineOffer engine = EngineOffer.working(engineId, "", "", () -> Engines.open(engineId));
        Gui.run(new GuiOptions(SceneReader.read(file), file, engine));
        return Main.OK;
    }
}
