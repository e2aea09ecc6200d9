package dev.twister.gui.picture;

import dev.twister.gui.controls.Problems;
import dev.twister.gui.model.ScreenColor;
import dev.twister.gui.model.ViewedPicture;
import dev.twister.gui.studio.Errands;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.world.TonedPixels;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javafx.scene.control.ColorPicker;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Slider;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;

/**
 * A picture that can be magnified, with its exposure, the strengths and colors of its lights, and its pixels' values.
 */
final class ViewerPane extends BorderPane {
    private static final double STEP = 1.25;
    private static final double MOST_ZOOM = 64;
    private static final double LEAST_ZOOM = 1.0 / 16;
    private static final double STOPS = 6;
    private static final double MOST_STRENGTH = 4;

    private final ViewedPicture picture;
    private final Errands errands;
    private final ImageView view = new ImageView();
    private final Label values = new Label();
    private final Slider exposure = new Slider(-STOPS, STOPS, 0);
    private final List<LightControls> lights = new ArrayList<>();
    private float[] shown;
    private double zoom = 1;
    private boolean toning;
    private boolean toneAgain;

    /** What changes a light. */
    private record LightControls(Slider strength, ColorPicker color) {
        Rgb factor() {
            Color picked = color.getValue();
            Rgb linear = ScreenColor.linear(new Rgb(picked.getRed(), picked.getGreen(), picked.getBlue()), true);
            double times = strength.getValue();
            return new Rgb(times * linear.red(), times * linear.green(), times * linear.blue());
        }
    }

    /** What is computed in the background. */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    private record Toned(float[] radiance, int[] argb) {}

    ViewerPane(ViewedPicture picture, Errands errands) {
        this.picture = picture;
        this.errands = errands;
        shown = picture.radiance();
        ScrollPane scroll = new ScrollPane(view);
        scroll.setPannable(true);
        scroll.getStyleClass().add("help");
        scroll.addEventFilter(ScrollEvent.SCROLL, event -> {
            zoomTo(zoom * (event.getDeltaY() > 0 ? STEP : 1 / STEP));
            event.consume();
        });
        view.setId("viewed");
        view.addEventHandler(MouseEvent.MOUSE_MOVED, event -> tell(event.getX(), event.getY()));
        values.setId("viewed-values");
        values.setText(picture.width() + " × " + picture.height());
        VBox controls = new VBox(row("Exposure", "stops", exposure));
        controls.getStyleClass().add("sections");
        for (ViewedPicture.Light light : picture.lights()) {
            LightControls change = new LightControls(new Slider(0, MOST_STRENGTH, 1), new ColorPicker(Color.WHITE));
            change.color().setId("light-" + light.group());
            change.color().setAccessibleText("Color of light " + light.group());
            change.color().valueProperty().subscribe((_, _) -> tone());
            lights.add(change);
            HBox row = row("Light: " + light.group(), "×", change.strength());
            row.getChildren().add(change.color());
            controls.getChildren().add(row);
        }
        HBox status = new HBox(values);
        status.getStyleClass().add("status");
        setCenter(scroll);
        setRight(controls);
        setBottom(status);
        tone();
    }

    private HBox row(String name, String unit, Slider slider) {
        Label label = new Label(name);
        label.getStyleClass().add("row-name");
        label.setLabelFor(slider);
        Label value = new Label();
        slider.valueProperty().subscribe(number -> {
            value.setText(String.format(Locale.ROOT, "%.2f %s", number.doubleValue(), unit));
            tone();
        });
        HBox row = new HBox(label, slider, value);
        row.getStyleClass().add("row");
        return row;
    }

    /** Computes the pixels in the background; once more if something changes meanwhile. */
    private void tone() {
        toneAgain = toning;
        if (!toning) {
            toning = true;
            double stops = exposure.getValue();
            List<Rgb> factors = lights.stream().map(LightControls::factor).toList();
            errands.run(() -> toned(stops, factors), this::show, this::complain);
        }
    }

    private Toned toned(double stops, List<Rgb> factors) {
        float[] radiance = picture.lit(factors);
        Rendering settings = Rendering.DEFAULT.withTone(stops, Rendering.DEFAULT.toneMap(), true);
        return new Toned(radiance, TonedPixels.of(radiance, settings));
    }

    private void show(Toned toned) {
        shown = toned.radiance();
        view.setImage(new WritableImage(new PixelBuffer<>(
                picture.width(), picture.height(), IntBuffer.wrap(toned.argb()), PixelFormat.getIntArgbPreInstance())));
        toning = false;
        if (toneAgain) {
            tone();
        }
    }

    private void complain(Throwable problem) {
        toning = false;
        values.setText(Problems.explain(problem));
    }

    private void zoomTo(double wanted) {
        zoom = Math.clamp(wanted, LEAST_ZOOM, MOST_ZOOM);
        view.setSmooth(zoom < 1);
        view.setFitWidth(picture.width() * zoom);
        view.setFitHeight(picture.height() * zoom);
    }

    private void tell(double x, double y) {
        int column = Math.clamp((int) (x / zoom), 0, picture.width() - 1);
        int row = Math.clamp((int) (y / zoom), 0, picture.height() - 1);
        values.setText(String.format(
                Locale.ROOT,
                "%d × %d · pixel %d, %d · red %.4g, green %.4g, blue %.4g · %.0f %%",
                picture.width(),
                picture.height(),
                column,
                row,
                shown[picture.at(column, row, 0)],
                shown[picture.at(column, row, 1)],
                shown[picture.at(column, row, 2)],
                100 * zoom));
    }
}
