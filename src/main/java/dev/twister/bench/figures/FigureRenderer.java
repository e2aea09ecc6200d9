package dev.twister.bench.figures;

import dev.twister.bench.figures.PaperFigures.FigureCommands;
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
import java.util.Locale;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

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

    /** Draws the light's disc as seen from a surface point, with the targets of its shadow rays. */
    private static final class DiscDrawing {
        /** Side of the square drawing, in pixels. */
        static final int SIDE = 360;

        private static final double RADIUS = 165;
        private static final double LARGEST_DOT = 9;

        private DiscDrawing() {}

        /**
         * An SVG document.
         *
         * @param json of {@code twister explain --json}; its first step has shadow rays, the first of them to the
         *     disc's center
         * @param discRadius in meters
         */
        static String svg(String json, double discRadius) {
            JsonNode surface =
                    JsonMapper.shared().readTree(json).get("steps").get(0).get("surface");
            JsonNode rays = surface.get("shadowRays");
            double[] axis = vector(surface.get("toLight"));
            double across = Math.hypot(axis[1], axis[2]);
            double[] u = {0, axis[2] / across, -axis[1] / across};
            double[] w = cross(u, axis);
            double[] center = vector(rays.get(0).get("target"));
            double dot = Math.min(LARGEST_DOT, 2 * LARGEST_DOT * Math.pow(rays.size(), -0.28));
            StringBuilder svg = new StringBuilder();
            svg.append("""
                    <svg xmlns="http://www.w3.org/2000/svg" width="360" height="360" viewBox="0 0 360 360">
                    <rect width="360" height="360" fill="#22262e"/>
                    <circle cx="180" cy="180" r="165" fill="none" stroke="#8a93a6" stroke-width="2"/>
                    """);
            for (JsonNode ray : rays) {
                double[] target = vector(ray.get("target"));
                double[] away = {target[0] - center[0], target[1] - center[1], target[2] - center[2]};
                svg.append(String.format(
                        Locale.ROOT,
                        "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\"/>\n",
                        SIDE / 2.0 + RADIUS * dot(away, u) / discRadius,
                        SIDE / 2.0 - RADIUS * dot(away, w) / discRadius,
                        dot,
                        ray.get("light").doubleValue() > 0 ? "#ffd34d" : "#6b7280"));
            }
            return svg.append("</svg>\n").toString();
        }

        private static double[] vector(JsonNode node) {
            return new double[] {
                node.get(0).doubleValue(),
                node.get(1).doubleValue(),
                node.get(2).doubleValue()
            };
        }

        private static double dot(double[] a, double[] b) {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        }

        private static double[] cross(double[] a, double[] b) {
            return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        }
    }
}
