package dev.twister.bench.figures;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The paper's rendered figures in the order of its sections, with the commands that render them. */
public final class PaperFigures {
    private static final String BENCHMARK = "benchmark";

    /** A point on the plane in the half shadow of two spheres. */
    private static final String PENUMBRA = "258,250";

    private PaperFigures() {}

    /**
     * Renders all figures.
     *
     * @param home Twister's folder, with the shipped scenes and skies
     * @throws IOException if a temporary file cannot be written
     */
    public static List<RenderedFigure> render(FigureCommands commands, Path home, String engineId) throws IOException {
        try (FigureRenderer renderer = new FigureRenderer(commands, home, engineId)) {
            return List.of(
                    closestHit(renderer),
                    reflectivity(renderer),
                    blinnPhong(renderer),
                    hardShadows(renderer),
                    disc(renderer),
                    softShadows(renderer),
                    bounces(renderer),
                    reflections(renderer),
                    skybox(renderer));
        }
    }

    private static RenderedFigure closestHit(FigureRenderer renderer) throws IOException {
        return figure(
                "The closest hit",
                """
                ray:     X(t) = O + t D,  |D| = 1
                sphere:  t = −b − √(b² − c),  b = D · (O − M),  c = |O − M|² − r²
                plane:   t = (h − O.y) / D.y""",
                "Each pixel has the base color of the body whose distance t > 0 is the smallest; where no body is hit,"
                        + " it has the skybox.",
                renderer.rendered("Base color of the closest hit.", BENCHMARK, "closest-hit", "--stage", "colors"));
    }

    private static RenderedFigure reflectivity(FigureRenderer renderer) throws IOException {
        return figure(
                "Levels of reflectivity",
                "color = shade((1 − p / 128) C + p / 128 · reflected color),  p in [0, 128]",
                "From left to right p is 0, 8, 16, 32, 64, 96 and 128: the highlight becomes smaller and sharper,"
                        + " and the"
                        + " mirror's share grows from none to all.",
                renderer.rendered("Seven spheres of one color.", "docs/lessons/reflectivity.json", "reflectivity"));
    }

    private static RenderedFigure blinnPhong(FigureRenderer renderer) throws IOException {
        return figure(
                "Blinn-Phong and its parts",
                """
                shade(C) = C max(a, max(0, N · L) S) + lightColor spec,  here S = 1
                spec = (8 + p) / (8π) · max(0, N · H)^p · p / 128,  H = (L + V) / |L + V|""",
                "The ambient part is the least that a surface sends back, the diffuse part follows the angle to the"
                        + " light,"
                        + " and the highlight is where N and H agree.",
                renderer.rendered(
                        "Ambient alone: a C with a = 0.2, which is 2^−2.3219 times the base color (the sky is as"
                                + " dark).",
                        BENCHMARK,
                        "ambient",
                        "--stage",
                        "colors",
                        "--exposure",
                        "-2.3219"),
                renderer.rendered("Diffuse: C max(a, N · L).", BENCHMARK, "diffuse", "--stage", "diffuse"),
                renderer.rendered(
                        "Highlights alone: the same scene with black bodies and a black sky.",
                        "docs/lessons/highlights-alone.json",
                        "highlights-alone",
                        "--stage",
                        "highlights"),
                renderer.rendered("All parts together.", BENCHMARK, "blinn-phong", "--stage", "highlights"));
    }

    private static RenderedFigure hardShadows(FigureRenderer renderer) throws IOException {
        return figure(
                "Hard shadows",
                "S = 0 where a body lies between the point and the light's center, else 1",
                "One shadow ray per point: the edges of the shadows are sharp.",
                renderer.rendered("One shadow ray.", BENCHMARK, "hard-shadows", "--stage", "hard-shadows"));
    }

    private static RenderedFigure disc(FigureRenderer renderer) throws IOException {
        List<RenderedFigure.Picture> discs = new ArrayList<>();
        for (int samples : new int[] {1, 10, 100, 500}) {
            discs.add(renderer.disc(BENCHMARK, PENUMBRA, samples));
        }
        return figure(
                "Samples on the light's disc",
                "r(i) = 2 R √(i / n),  θ(i) = i π (3 − √5),  i = 0 … n − 1",
                "Vogel's sunflower spreads n points evenly over the disc about the light's center. These are the"
                        + " targets of"
                        + " the shadow rays of one point on the plane: yellow where the ray is free, gray where a"
                        + " sphere"
                        + " blocks it.",
                discs.toArray(RenderedFigure.Picture[]::new));
    }

    private static RenderedFigure softShadows(FigureRenderer renderer) throws IOException {
        List<RenderedFigure.Picture> pictures = new ArrayList<>();
        for (String samples : List.of("10", "100", "500")) {
            pictures.add(renderer.rendered(
                    samples + " shadow rays per point.",
                    BENCHMARK,
                    "soft-shadows-" + samples,
                    "--stage",
                    "soft-shadows",
                    "--shadow-samples",
                    samples));
        }
        return figure(
                "Soft shadows",
                "S = 1 − blocked / n",
                "With few rays the half shadow has steps; with many it is smooth.",
                pictures.toArray(RenderedFigure.Picture[]::new));
    }

    private static RenderedFigure bounces(FigureRenderer renderer) throws IOException {
        List<RenderedFigure.Picture> pictures = new ArrayList<>();
        for (String bounces : List.of("0", "1", "2")) {
            pictures.add(renderer.rendered(
                    "Bounces: " + bounces + ".",
                    BENCHMARK,
                    "bounces-" + bounces,
                    "--bounces",
                    bounces,
                    "--shadow-samples",
                    "200"));
        }
        return figure(
                "Reflections, bounce by bounce",
                "color(i) = shade_i((1 − k_i) C_i + k_i color(i + 1)),  k_i = p_i / 128, 0 at the last bounce",
                "Without bounces no body is a mirror; with one, mirrors show matte bodies; with two, mirrors in"
                        + " mirrors.",
                pictures.toArray(RenderedFigure.Picture[]::new));
    }

    private static RenderedFigure reflections(FigureRenderer renderer) throws IOException {
        return figure(
                "Reflections",
                "D' = D − 2 (D · N) N",
                "Among mirrors a ray is reflected many times before it ends in the sky or at the limit of bounces.",
                renderer.rendered("A hall of mirrors.", "mirrors", "reflections"));
    }

    private static RenderedFigure skybox(FigureRenderer renderer) throws IOException {
        return figure(
                "The skybox",
                "u = 0.5 + atan2(D.x, D.z) / 2π,  v = 0.5 − asin(D.y) / π",
                "A ray that hits no body takes the color of a panorama in its direction.",
                renderer.rendered("The day sky.", BENCHMARK, "sky-day", "--pitch", "-15", "--fov", "90"),
                renderer.rendered(
                        "The same view under another panorama.",
                        BENCHMARK,
                        "sky-sunset",
                        "--pitch",
                        "-15",
                        "--fov",
                        "90",
                        "--skybox",
                        "skyboxes/sunset.hdr"));
    }

    private static RenderedFigure figure(
            String title, String equation, String sentence, RenderedFigure.Picture... pictures) {
        return new RenderedFigure(title, equation, sentence, List.of(pictures));
    }

    /** Runs the commands of the paper's figures, such as {@code twister render}, in this process. */
    @FunctionalInterface
    public interface FigureCommands {
        /**
         * Runs a command; if it fails, throws an exception with its error message.
         *
         * @param out receives its standard output
         */
        void run(Writer out, List<String> arguments);
    }
}
