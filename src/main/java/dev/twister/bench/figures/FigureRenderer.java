package dev.twister.bench.figures;

import dev.twister.files.TemporaryFolder;
import dev.twister.scene.format.SceneReader;
import java.io.IOException;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Renders figures by the commands that the page shows for them. */
final class FigureRenderer implements AutoCloseable {
    private static final String ENDING = ".json";
    private static final String LAUNCHER = "scripts/twister ";
    private static final int WIDTH = 640;
    private static final int HEIGHT = 360;
    private static final String SIZE = WIDTH + "x" + HEIGHT;

    private final FigureCommands commands;
    private final Path home;
    private final String engineId;
    private final TemporaryFolder folder;

    FigureRenderer(FigureCommands commands, Path home, String engineId) throws IOException {
        this.commands = commands;
        this.home = home;
        this.engineId = engineId;
        folder = TemporaryFolder.create();
    }

    /**
     * Renders a scene.
     *
     * @param scene a shipped scene's name, or a file in Twister's folder
     * @param name name of the picture's file, without its ending
     * @param options of {@code twister render}
     */
    RenderedFigure.Picture rendered(String caption, String scene, String name, String... options) throws IOException {
        Path file = folder.path().resolve(name + ".png");
        List<String> arguments =
                new ArrayList<>(List.of("render", sceneFile(scene).toString(), "-o", file.toString(), "--size", SIZE));
        for (String option : options) {
            arguments.add(option.startsWith("skyboxes/") ? home.resolve(option).toString() : option);
        }
        arguments.addAll(List.of("--engine", engineId));
        commands.run(Writer.nullWriter(), arguments);
        byte[] picture = Files.readAllBytes(file);
        String command = LAUNCHER + String.join(" ", "render", scene, "-o", name + ".png", "--size", SIZE);
        return new RenderedFigure.Picture(
                caption,
                shown(scene),
                options.length == 0 ? command : command + " " + String.join(" ", options),
                "png",
                picture,
                WIDTH,
                HEIGHT);
    }

    /** Draws the targets of a pixel's first shadow rays on the light's disc. */
    RenderedFigure.Picture disc(String scene, String pixel, int samples) {
        Path file = sceneFile(scene);
        List<String> options =
                List.of("--pixel", pixel, "--size", SIZE, "--shadow-samples", Integer.toString(samples), "--json");
        List<String> arguments = new ArrayList<>(List.of("explain", file.toString()));
        arguments.addAll(options);
        StringWriter json = new StringWriter();
        commands.run(json, arguments);
        double radius = SceneReader.read(file).lights().first().radius();
        String svg = DiscDrawing.svg(json.toString(), 2 * radius);
        return new RenderedFigure.Picture(
                samples + (samples == 1 ? " sample." : " samples."),
                shown(scene),
                LAUNCHER + "explain " + scene + " " + String.join(" ", options),
                "svg+xml",
                svg.getBytes(StandardCharsets.UTF_8),
                DiscDrawing.SIDE,
                DiscDrawing.SIDE);
    }

    /** The scene file of a command, in Twister's folder instead of the current one. */
    private Path sceneFile(String scene) {
        return home.resolve(shown(scene));
    }

    private static String shown(String scene) {
        return scene.endsWith(ENDING) ? scene : "scenes/" + scene + ENDING;
    }

    @Override
    public void close() throws IOException {
        folder.close();
    }
}
