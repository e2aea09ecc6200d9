package dev.twister.bench.paper;

import dev.twister.bench.PublishedFigures;
import dev.twister.bench.ReportNumbers;
import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.PaperFigure;
import dev.twister.bench.benchmark.Setting;
import dev.twister.bench.figures.RenderedFigure;
import dev.twister.bench.page.FiguresPage;
import dev.twister.bench.page.HtmlText;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The evaluation as a self-contained HTML page. */
final class PaperPage {
    private final BenchmarkReport report;
    private final Map<String, String> plots;
    private final Map<Setting, byte[]> pictures;
    private final List<RenderedFigure> figures;

    private PaperPage(
            BenchmarkReport report,
            Map<String, String> plots,
            Map<Setting, byte[]> pictures,
            List<RenderedFigure> figures) {
        this.report = report;
        this.plots = plots;
        this.pictures = pictures;
        this.figures = figures;
    }

    /**
     * The page's HTML.
     *
     * @param plots SVG documents by name
     * @param pictures the reference's pictures as PNG data
     * @param figures the paper's rendered figures
     */
    static String of(
            BenchmarkReport report,
            Map<String, String> plots,
            Map<Setting, byte[]> pictures,
            List<RenderedFigure> figures)
            throws IOException {
        return new PaperPage(report, plots, pictures, figures).text();
    }

    private String text() throws IOException {
        return HtmlText.page(
                "Twister: the paper's evaluation on this machine",
                "The paper's evaluation, here",
                lead(),
                String.join(
                        "\n",
                        problems(),
                        sizes(),
                        shadows(),
                        bounces(),
                        speedup(),
                        drawn(),
                        FiguresPage.sections(figures),
                        about()));
    }

    private String lead() {
        String repeated = "Twister repeats the evaluation of “" + PublishedFigures.PAPER + "” ("
                + PublishedFigures.AUTHORS + ") on " + report.machine().processor() + ", "
                + report.machine().cores() + " cores.";
        return String.join(
                " ",
                Stream.of(repeated, report.fastestEngines(), first())
                        .filter(text -> !text.isEmpty())
                        .toList());
    }

    /** The fastest engine at the paper's first setting, beside the paper. */
    private String first() {
        Setting first = report.plan().settings(PaperFigure.SIZES).getFirst();
        return report.fastest(first)
                .map(fastest -> "At " + first.size().name() + " with hard shadows and one bounce, " + fastest.engine()
                        + " renders " + PlotLook.number(fastest.times().fps()) + " frames per second"
                        + PublishedFigures.fps(first.size())
                                .map(fps -> "; the paper reports " + PlotLook.number(fps) + " on an "
                                        + PublishedFigures.DEVICE + ".")
                                .orElse("."))
                .orElse("");
    }

    private String problems() {
        return report.problems().stream()
                .map(problem -> "<p class=\"failed\">" + HtmlText.escaped(problem) + "</p>\n")
                .collect(Collectors.joining());
    }

    private String sizes() {
        return section(
                PaperFigure.SIZES.title(),
                plot(
                        PaperFigure.SIZES.id(),
                        "Hard shadows (one sample), one bounce. The gray bars are the paper's own figures on an "
                                + PublishedFigures.DEVICE + ", not measured here."),
                PaperTables.sizes(report));
    }

    private String shadows() {
        return section(
                PaperFigure.SHADOW_SAMPLES.title(),
                plot(PaperFigure.SHADOW_SAMPLES.id(), "Points on the light's disc, with one bounce."),
                PaperTables.fps(
                        report,
                        PaperFigure.SHADOW_SAMPLES,
                        setting -> ReportNumbers.counted(setting.shadowSamples(), "sample")));
    }

    private String bounces() {
        return section(
                PaperFigure.BOUNCES.title(),
                plot(
                        PaperFigure.BOUNCES.id(),
                        "Limit of reflections, with " + PaperPlan.SOFT_SHADOW_SAMPLES + " shadow samples."),
                PaperTables.fps(
                        report, PaperFigure.BOUNCES, setting -> ReportNumbers.counted(setting.bounces(), "bounce")));
    }

    private String speedup() {
        String figures = plots.keySet().stream()
                .filter(name -> name.startsWith(PaperFigure.SPEEDUP.id()))
                .map(name -> plot(
                        name,
                        "Mean times of a frame compared, with " + PaperPlan.SOFT_SHADOW_SAMPLES + " shadow samples and "
                                + PaperPlan.MANY_BOUNCES + " bounces."))
                .collect(Collectors.joining());
        String note =
                "<p class=\"note\">The paper's baseline is its own program's parallel streams; Twister's baselines"
                        + " already have the kernel's shortcuts, so the same device gains less over them.</p>\n";
        return section(PaperFigure.SPEEDUP.title(), figures, PaperTables.speedup(report) + note);
    }

    private String drawn() {
        String figures = report.plan().shown().stream()
                .filter(pictures::containsKey)
                .map(setting -> "<figure>"
                        + HtmlText.image(
                                "The scene as drawn",
                                "png",
                                pictures.get(setting),
                                setting.size().width(),
                                setting.size().height())
                        + "<figcaption>" + HtmlText.escaped(setting.toString())
                        + "</figcaption></figure>\n")
                .collect(Collectors.joining());
        return section("What was drawn", "<div class=\"pictures\">\n" + figures + "</div>\n", "");
    }

    private String about() {
        return section("The machine", PaperTables.machine(report), "")
                + section("How it was measured", PaperTables.parameters(report), "");
    }

    private String plot(String name, String caption) {
        return Optional.ofNullable(plots.get(name))
                .map(svg -> "<figure>"
                        + HtmlText.image(
                                caption,
                                "svg+xml",
                                svg.getBytes(StandardCharsets.UTF_8),
                                PlotLook.WIDTH,
                                PlotLook.HEIGHT)
                        + "<figcaption>" + HtmlText.escaped(caption) + "</figcaption></figure>\n")
                .orElse("");
    }

    private static String section(String title, String first, String second) {
        return "<section>\n<h2>" + HtmlText.escaped(title) + "</h2>\n" + first + second + "</section>\n";
    }
}
