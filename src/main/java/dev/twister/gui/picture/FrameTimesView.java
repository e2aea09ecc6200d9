package dev.twister.gui.picture;

import dev.twister.bench.ReportNumbers;
import dev.twister.gui.studio.FrameHistory;
import dev.twister.gui.studio.Studio;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.value.ObservableDoubleValue;
import javafx.geometry.VPos;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.control.Label;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import javafx.scene.text.TextAlignment;

/** Frames a second, milliseconds, and a graph of the last ten seconds, over the picture's corner. */
public final class FrameTimesView extends VBox {
    /** Faster than one reads. */
    private static final long REDRAW_NANOS = 200_000_000;

    private static final double NANOS_PER_SECOND = 1e9;
    /** Wider than the usual numbers, so that it stays as wide when they change. */
    private static final double WIDTH_EM = 33;

    /** With less room the picture is what counts: frames a second, and nothing else. */
    private static final double LEAST_WIDTH_EM = 18;

    private static final String SEPARATOR = "   ";
    private static final char NO_BREAK = '\u00a0';
    private static final double HEIGHT_EM = 6;

    /** For the scale's labels, which end there. */
    private static final double MARGIN_EM = 4.2;

    private static final double GAP_EM = 0.5;
    private static final Color LINE = Color.web("#5b93ff");
    private static final Color GRID = Color.web("#ffffff40");
    private static final Color TEXT = Color.web("#d5d7da");

    private final Label numbers = new Label();
    private final Canvas graph = new Canvas();
    private final Studio studio;
    private final FrameHistory history;
    private final ObservableDoubleValue room;
    private long drawnNanos;
    private boolean emptied;

    /**
     * A view that is empty until {@link #refresh}.
     *
     * @param room the width that there is
     */
    public FrameTimesView(Studio studio, ObservableDoubleValue room) {
        this.studio = studio;
        history = studio.frames();
        this.room = room;
        numbers.setWrapText(true);
        getStyleClass().add("frame-times");
        setMouseTransparent(true);
        setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
        getChildren().addAll(numbers, graph);
    }

    /** Called in every pulse; redraws a few times a second while visible. */
    public void refresh(long nanos) {
        if (isVisible() && nanos - drawnNanos >= REDRAW_NANOS && !isOver(nanos)) {
            drawnNanos = nanos;
            double em = numbers.getFont().getSize();
            double wide = room.get() - getInsets().getLeft() - getInsets().getRight();
            boolean narrow = wide < LEAST_WIDTH_EM * em;
            List<String> parts = parts(history, nanos, studio.restingSamples());
            numbers.setText(String.join(SEPARATOR, narrow ? parts.subList(0, 1) : parts));
            numbers.setMaxWidth(wide);
            graph.setVisible(!narrow);
            graph.setManaged(!narrow);
            if (!narrow) {
                graph.setWidth(Math.min(WIDTH_EM * em, wide));
                graph.setHeight(HEIGHT_EM * em);
                draw(nanos, em);
            }
        }
    }

    /** Whether the graph of a picture at rest has become empty, and no more comes. */
    private boolean isOver(long nanos) {
        boolean empty =
                studio.restingSamples().isPresent() && history.entries(nanos).isEmpty();
        boolean over = empty && emptied;
        emptied = empty;
        return over;
    }

    /**
     * Frames a second, then what they took; a line breaks between the parts only.
     *
     * @param resting samples per pixel of the finished picture, if nothing is drawn any more
     */
    public static List<String> parts(FrameHistory history, long nanos, Optional<Integer> resting) {
        FrameHistory.Entry mean = history.mean();
        return Stream.of(
                        resting.map(samples ->
                                        "idle, " + samples + (samples == 1 ? " sample" : " samples") + " per pixel")
                                .orElseGet(() -> ReportNumbers.legible(history.framesPerSecond(nanos), 1) + " FPS"),
                        String.format(Locale.ROOT, "render %.1f ms", mean.renderMillis()),
                        String.format(Locale.ROOT, "transfer %.1f ms", mean.transferMillis()),
                        String.format(Locale.ROOT, "display %.2f ms", mean.displayMillis()))
                .map(part -> part.replace(' ', NO_BREAK))
                .toList();
    }

    private void draw(long nanos, double em) {
        List<FrameHistory.Entry> entries = history.entries(nanos);
        double top = GraphScale.above(entries.stream()
                .mapToDouble(entry -> entry.renderMillis() + entry.transferMillis())
                .max()
                .orElse(0));
        double margin = MARGIN_EM * em;
        double left = margin + GAP_EM * em;
        double width = graph.getWidth() - left;
        double height = graph.getHeight();
        GraphicsContext pen = graph.getGraphicsContext2D();
        pen.clearRect(0, 0, graph.getWidth(), height);
        pen.setFont(numbers.getFont());
        pen.setFill(TEXT);
        pen.setTextAlign(TextAlignment.RIGHT);
        pen.setStroke(GRID);
        pen.setLineWidth(1);
        // Half a line's height above and below the graph, so that labels are level with their lines.
        double upper = em / 2;
        double lower = height - em / 2;
        for (double share : new double[] {0, 0.5, 1}) {
            double y = Math.floor(lower + share * (upper - lower)) + 0.5;
            pen.strokeLine(left, y, left + width, y);
            pen.setTextBaseline(VPos.CENTER);
            pen.fillText(GraphScale.label(share * top, top), margin, y);
        }
        pen.setStroke(LINE);
        pen.setLineWidth(Math.max(1, em / 8));
        double[] x = new double[entries.size()];
        double[] y = new double[entries.size()];
        for (int i = 0; i < x.length; i++) {
            FrameHistory.Entry entry = entries.get(i);
            double age = (nanos - entry.nanos()) / NANOS_PER_SECOND;
            x[i] = left + width * (1 - age / FrameHistory.SECONDS);
            y[i] = lower + (entry.renderMillis() + entry.transferMillis()) / top * (upper - lower);
        }
        pen.strokePolyline(x, y, x.length);
    }

    /** The upper end of the graph: a number that one can read, above all that is shown. */
    public static final class GraphScale {
        private static final double MOST_MILLIS = 1000;
        private static final double[] STEPS = {1, 2, 5, 10};

        private GraphScale() {}

        /** The next of 1, 2, 5, 10, 20, ... milliseconds. */
        public static double above(double millis) {
            double decade = Math.pow(10, Math.floor(Math.log10(Math.max(1, millis))));
            for (double step : STEPS) {
                if (millis <= step * decade) {
                    return step * decade;
                }
            }
            return 10 * decade;
        }

        /** A time on a scale that ends at {@code topMillis}: all of its labels have one unit, and few letters. */
        public static String label(double millis, double topMillis) {
            boolean seconds = topMillis > MOST_MILLIS;
            double number = seconds ? millis / MOST_MILLIS : millis;
            return String.format(Locale.ROOT, number == Math.rint(number) ? "%.0f" : "%.1f", number)
                    + (seconds ? " s" : " ms");
        }
    }
}
