package dev.twister.gui.picture;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.CommandActions;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.StagesAndViews;
import dev.twister.gui.studio.Studio;
import dev.twister.image.Histogram;
import dev.twister.world.StageOrView;
import java.util.Locale;
import java.util.stream.IntStream;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.effect.BlendMode;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;

/** The histogram of the picture's color levels, and the clipped part. */
public final class HistogramView extends VBox {
    /** Faster than one reads. */
    private static final long REDRAW_NANOS = 100_000_000;

    /** A share of a tenth of a percent is some sixty of them. */
    private static final int MOST_PIXELS = 1 << 16;

    private static final double HEIGHT_EM = 5;
    private static final double LEAST_SHARE = 0.001;
    private static final double WHOLE_PERCENT = 0.1;
    private static final Color RED = Color.web("#7c1f27");
    private static final Color GREEN = Color.web("#1a6a2a");
    private static final Color BLUE = Color.web("#1c3692");
    private static final Color LUMA = Color.web("#e8eaee");

    private final Studio studio;
    private final Canvas canvas = new Canvas();
    private final Label clipped = new Label();
    private long drawnNanos;
    private long drawnPicture = -1;
    private double drawnWidth;

    public HistogramView(Studio studio, CommandActions actions) {
        this.studio = studio;
        getStyleClass().add("histogram");
        Pane frame = new Pane(canvas);
        frame.getStyleClass().add("histogram-frame");
        frame.setMinWidth(0);
        canvas.widthProperty().bind(frame.widthProperty());
        canvas.heightProperty().bind(clipped.fontProperty().map(font -> HEIGHT_EM * font.getSize()));
        frame.prefHeightProperty().bind(canvas.heightProperty());
        clipped.setId("clipped");
        clipped.getStyleClass().add("hint");
        clipped.setWrapText(true);
        clipped.setTooltip(Tooltips.of(
                "White: a channel is at 255, and what was brighter is lost. Black: all" + " channels are at 0."));
        clipped.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(clipped, Priority.ALWAYS);
        Button auto = actions.button("auto-exposure", Command.AUTO_EXPOSURE);
        auto.setMinWidth(USE_PREF_SIZE);
        studio.shownProperty().subscribe(shown -> auto.setDisable(!shown.isColor()));
        HBox below = new HBox(clipped, auto);
        below.getStyleClass().add("row");
        getChildren().addAll(frame, below);
    }

    /** Called in every pulse while it may be visible: redraws if the picture has changed. */
    public void pulse(long nanos) {
        if (nanos - drawnNanos >= REDRAW_NANOS) {
            studio.pictureProperty().get().ifPresent(picture -> {
                if (picture.number() != drawnPicture || canvas.getWidth() != drawnWidth) {
                    drawnNanos = nanos;
                    drawnPicture = picture.number();
                    drawnWidth = canvas.getWidth();
                    show(picture);
                }
            });
        }
    }

    /** Why a view has no exposure. */
    static String without(StageOrView shown) {
        return StagesAndViews.label(shown) + " has no exposure: its colors are not light";
    }

    private void show(DrawnPicture picture) {
        GraphicsContext pen = canvas.getGraphicsContext2D();
        pen.clearRect(0, 0, canvas.getWidth(), canvas.getHeight());
        if (picture.request().shown().isColor()) {
            Histogram histogram =
                    Histogram.of(picture.frame().argb(), picture.frame().width(), MOST_PIXELS);
            draw(pen, histogram);
            clipped.setText(text(histogram));
        } else {
            clipped.setText(without(picture.request().shown()));
        }
    }

    /** Such as {@code Clipped: 0.3 % white, 0 % black}. */
    static String text(Histogram histogram) {
        return "Clipped: " + percent(histogram.whiteShare()) + " white, " + percent(histogram.blackShare()) + " black";
    }

    private static String percent(double share) {
        if (share == 0) {
            return "0 %";
        }
        if (share < LEAST_SHARE) {
            return "under 0.1 %";
        }
        return String.format(Locale.ROOT, share < WHOLE_PERCENT ? "%.1f %%" : "%.0f %%", 100 * share);
    }

    private void draw(GraphicsContext pen, Histogram histogram) {
        int most = Math.max(
                1,
                IntStream.range(1, Histogram.LEVELS - 1)
                        .map(level -> Math.max(
                                Math.max(histogram.red()[level], histogram.green()[level]),
                                histogram.blue()[level]))
                        .max()
                        .orElse(1));
        pen.setGlobalBlendMode(BlendMode.ADD);
        fill(pen, RED, histogram.red(), most);
        fill(pen, GREEN, histogram.green(), most);
        fill(pen, BLUE, histogram.blue(), most);
        pen.setGlobalBlendMode(BlendMode.SRC_OVER);
        pen.setStroke(LUMA);
        pen.setLineWidth(1);
        pen.strokePolyline(across(), up(histogram.luma(), most), Histogram.LEVELS);
    }

    private void fill(GraphicsContext pen, Color color, int[] counts, int most) {
        double[] x = new double[Histogram.LEVELS + 2];
        double[] y = new double[Histogram.LEVELS + 2];
        System.arraycopy(across(), 0, x, 1, Histogram.LEVELS);
        System.arraycopy(up(counts, most), 0, y, 1, Histogram.LEVELS);
        x[Histogram.LEVELS + 1] = canvas.getWidth();
        y[0] = canvas.getHeight();
        y[Histogram.LEVELS + 1] = canvas.getHeight();
        pen.setFill(color);
        pen.fillPolygon(x, y, x.length);
    }

    private double[] across() {
        return IntStream.range(0, Histogram.LEVELS)
                .mapToDouble(level -> canvas.getWidth() * level / (Histogram.LEVELS - 1))
                .toArray();
    }

    /** Heights are square roots, so that rare levels stay visible; those of the clipped ends may be cut off. */
    private double[] up(int[] counts, int most) {
        return IntStream.of(counts)
                .mapToDouble(count -> canvas.getHeight() * (1 - Math.sqrt(Math.min(1, (double) count / most))))
                .toArray();
    }
}
