package dev.twister.bench.paper;

import dev.twister.bench.PublishedFigures;
import dev.twister.bench.ReportNumbers;
import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.Measurement;
import dev.twister.bench.benchmark.PaperFigure;
import dev.twister.bench.benchmark.Setting;
import dev.twister.engine.JvmEngines;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.ToIntFunction;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2D;
import org.apache.batik.svggen.SVGGraphics2DIOException;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.knowm.xchart.CategorySeries;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.internal.chartpart.Chart;
import org.knowm.xchart.style.markers.SeriesMarkers;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

/** The plots of the evaluation. */
final class PaperPlots {
    private static final List<String> BASELINES = List.of(JvmEngines.SEQUENTIAL, JvmEngines.PARALLEL);
    private static final String FPS = "frames per second";
    private static final float LINE_WIDTH = 2.5f;
    private static final int MARKER_SIZE = 9;
    private static final double BARS_SHARE = 0.85;

    /** Less than the full width, so that the outermost markers are not clipped. */
    private static final double LINES_SHARE = 0.96;

    /** Slightly above the bar. */
    private static final double LABEL_POSITION = 1.04;

    private final BenchmarkReport report;

    private PaperPlots(BenchmarkReport report) {
        this.report = report;
    }

    /** All plots as SVG, by name, except those without measurements. */
    static Map<String, String> of(BenchmarkReport report) {
        PaperPlots plots = new PaperPlots(report);
        Map<String, String> drawn = new LinkedHashMap<>();
        if (!report.measurements().isEmpty()) {
            drawn.put(PaperFigure.SIZES.id(), plots.sizes());
            drawn.put(
                    PaperFigure.SHADOW_SAMPLES.id(),
                    plots.lines(PaperFigure.SHADOW_SAMPLES, "shadow samples", Setting::shadowSamples));
            drawn.put(PaperFigure.BOUNCES.id(), plots.lines(PaperFigure.BOUNCES, "bounces", Setting::bounces));
            for (String baseline : BASELINES) {
                if (report.engines().contains(baseline) && report.engines().size() > 1) {
                    drawn.put(speedupName(baseline), plots.speedup(baseline));
                }
            }
        }
        return drawn;
    }

    /** The names of all possible plots. */
    static List<String> names() {
        return Stream.concat(
                        Stream.of(PaperFigure.SIZES, PaperFigure.SHADOW_SAMPLES, PaperFigure.BOUNCES)
                                .map(PaperFigure::id),
                        BASELINES.stream().map(PaperPlots::speedupName))
                .toList();
    }

    private static String speedupName(String baseline) {
        return PaperFigure.SPEEDUP.id() + "-over-" + baseline;
    }

    private String sizes() {
        CategoryChart chart = bars("Hard shadows, one bounce", FPS);
        List<Setting> settings = report.plan().settings(PaperFigure.SIZES);
        List<Double> values = new ArrayList<>();
        for (String engine : report.engines()) {
            addBars(chart, engine, settings, setting -> report.fps(engine, setting), values);
        }
        if (settings.stream()
                .anyMatch(setting -> PublishedFigures.fps(setting.size()).isPresent())) {
            addBars(
                            chart,
                            PublishedFigures.DEVICE + " (the paper's figure)",
                            settings,
                            setting -> PublishedFigures.fps(setting.size()),
                            values)
                    .setFillColor(PlotLook.published());
        }
        PlotLook.scale(chart.getStyler(), values);
        return SvgPlot.of(chart, PaperFigure.SIZES.title());
    }

    private String speedup(String baseline) {
        CategoryChart chart = bars(
                "Times as fast as " + baseline + ", " + PaperPlan.SOFT_SHADOW_SAMPLES + " shadow samples, "
                        + PaperPlan.MANY_BOUNCES + " bounces",
                "speed-up");
        List<Double> values = new ArrayList<>();
        for (String engine : report.engines()) {
            if (!engine.equals(baseline)) {
                addBars(
                        chart,
                        engine,
                        report.plan().settings(PaperFigure.SPEEDUP),
                        setting -> report.find(engine, setting)
                                .flatMap(measurement -> report.speedupOver(baseline, measurement)),
                        values);
            }
        }
        PlotLook.scale(chart.getStyler(), values);
        return SvgPlot.of(chart, PaperFigure.SPEEDUP.title() + ": " + baseline);
    }

    private String lines(PaperFigure figure, String axis, ToIntFunction<Setting> place) {
        List<Setting> settings = report.plan().settings(figure);
        Setting first = settings.getFirst();
        String fixed = figure == PaperFigure.BOUNCES
                ? ReportNumbers.counted(first.shadowSamples(), "shadow sample")
                : ReportNumbers.counted(first.bounces(), "bounce");
        XYChart chart = new XYChartBuilder()
                .width(PlotLook.WIDTH)
                .height(PlotLook.HEIGHT)
                .title(first.size().name() + ", " + fixed)
                .xAxisTitle(axis)
                .yAxisTitle(FPS)
                .build();
        PlotLook.apply(chart.getStyler());
        chart.getStyler().setMarkerSize(MARKER_SIZE).setPlotContentSize(LINES_SHARE);
        List<Double> values = new ArrayList<>();
        for (String engine : report.engines()) {
            List<Measurement> measured = settings.stream()
                    .flatMap(setting -> report.find(engine, setting).stream())
                    .toList();
            if (!measured.isEmpty()) {
                List<Double> fps = measured.stream()
                        .map(measurement -> measurement.times().fps())
                        .toList();
                List<Integer> places = measured.stream()
                        .map(measurement -> place.applyAsInt(measurement.setting()))
                        .toList();
                XYSeries series = chart.addSeries(engine, places, fps);
                series.setMarker(SeriesMarkers.CIRCLE);
                series.setMarkerColor(color(engine));
                series.setLineColor(color(engine));
                series.setLineStyle(new BasicStroke(LINE_WIDTH));
                values.addAll(fps);
            }
        }
        chart.getStyler().setXAxisTickLabelsFormattingFunction(PlotLook::number);
        PlotLook.scale(chart.getStyler(), values);
        return SvgPlot.of(chart, figure.title());
    }

    private static CategoryChart bars(String title, String axis) {
        CategoryChart chart = new CategoryChartBuilder()
                .width(PlotLook.WIDTH)
                .height(PlotLook.HEIGHT)
                .title(title)
                .xAxisTitle("picture size")
                .yAxisTitle(axis)
                .build();
        PlotLook.apply(chart.getStyler());
        chart.getStyler()
                .setAvailableSpaceFill(BARS_SHARE)
                .setLabelsVisible(true)
                .setLabelsPosition(LABEL_POSITION)
                .setLabelsFont(PlotLook.labelFont())
                // Bars start at the axis.
                .setPlotContentSize(1);
        return chart;
    }

    private CategorySeries addBars(
            CategoryChart chart,
            String name,
            List<Setting> settings,
            Function<Setting, Optional<Double>> value,
            List<Double> values) {
        List<String> places =
                settings.stream().map(setting -> setting.size().name()).toList();
        List<Double> bars = new ArrayList<>();
        settings.forEach(setting -> bars.add(value.apply(setting).orElse(null)));
        bars.stream().filter(bar -> bar != null).forEach(values::add);
        CategorySeries series = chart.addSeries(name, places, bars);
        series.setFillColor(color(name));
        return series;
    }

    private Color color(String engine) {
        return PlotLook.color(Math.max(0, report.engines().indexOf(engine)));
    }

    /** Renders a plot as an SVG document. */
    private static final class SvgPlot {
        private static final String NAMESPACE = "http://www.w3.org/2000/svg";

        private SvgPlot() {}

        /** The document's text. Letters are converted to shapes, so that it looks the same with other fonts. */
        static String of(Chart<?, ?> chart, String description) {
            try {
                Document document = DocumentBuilderFactory.newDefaultNSInstance()
                        .newDocumentBuilder()
                        .getDOMImplementation()
                        .createDocument(NAMESPACE, "svg", null);
                SVGGeneratorContext context = SVGGeneratorContext.createDefault(document);
                context.setComment(null);
                SVGGraphics2D graphics = new SVGGraphics2D(context, true);
                graphics.setSVGCanvasSize(new Dimension(PlotLook.WIDTH, PlotLook.HEIGHT));
                chart.paint(graphics, PlotLook.WIDTH, PlotLook.HEIGHT);
                Element root = graphics.getRoot();
                root.setAttribute("viewBox", "0 0 " + PlotLook.WIDTH + " " + PlotLook.HEIGHT);
                root.setAttribute("role", "img");
                root.setAttribute("aria-label", description);
                StringWriter text = new StringWriter();
                graphics.stream(root, text, true, false);
                // Omits Batik's header, which refers to a document type definition on the network.
                String whole = text.toString();
                return whole.substring(whole.indexOf("<svg"));
            } catch (ParserConfigurationException | SVGGraphics2DIOException impossible) {
                throw new IllegalStateException("the plot cannot be written into memory", impossible);
            }
        }
    }
}
