package dev.twister.gui.viewer;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.Ids;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.picture.ShownRadiance;
import dev.twister.gui.property.ScreenColor;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.viewer.ComparedPictures.Mode;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.world.TonedPixels;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import javafx.animation.PauseTransition;
import javafx.application.Platform;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ColorPicker;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Slider;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToggleGroup;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import javafx.util.Duration;

/**
 * A picture that can be magnified, with its exposure, the strengths and colors of its lights, without noise if wanted,
 * and its pixels' values.
 */
final class ViewerPane extends BorderPane {
    private static final double STEP = 1.25;
    private static final double MOST_ZOOM = 64;
    private static final double LEAST_ZOOM = 1.0 / 16;
    private static final double STOPS = 6;
    private static final double MOST_STRENGTH = 4;
    private static final Duration REST = Duration.millis(300);

    private final ViewedPicture picture;
    private final BackgroundTasks tasks;
    private final ImageView view = new ImageView();
    private final Label values = new Label();
    private final Slider exposure = new Slider(-STOPS, STOPS, 0);
    private final List<LightControls> lights = new ArrayList<>();
    private final CheckBox denoise = new CheckBox("with Open Image Denoise");
    private final ViewedPicture.Denoising denoising;
    private final CompareControls compare = new CompareControls(this::take);
    private final Supplier<Optional<ShownRadiance>> rendering;
    private Optional<Other> other = Optional.empty();
    private float[] shown;
    private int shownWidth;
    private int wiped;
    private double zoom = 1;
    private boolean toning;
    private boolean toneAgain;
    private boolean cleaning;

    /** Ends when nothing has changed for some time. */
    private final PauseTransition rest = new PauseTransition(REST);

    /** What changes a light. */
    private record LightControls(Slider strength, ColorPicker color) {
        Rgb factor() {
            Color picked = color.getValue();
            Rgb linear = ScreenColor.linear(new Rgb(picked.getRed(), picked.getGreen(), picked.getBlue()), true);
            double times = strength.getValue();
            return new Rgb(times * linear.red(), times * linear.green(), times * linear.blue());
        }
    }

    /** The rendering that the picture is compared with. */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    private record Other(int width, int height, float[] radiance) {}

    /**
     * What is computed in the background.
     *
     * @param width of the pixels, which may be of two pictures
     * @param result what the comparison says; empty without one
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    private record Toned(float[] radiance, int width, int[] argb, String result) {}

    /** @param rendering the window's picture, if there is one */
    ViewerPane(ViewedPicture picture, BackgroundTasks tasks, Supplier<Optional<ShownRadiance>> rendering) {
        this.picture = picture;
        this.tasks = tasks;
        denoising = new ViewedPicture.Denoising(picture);
        rest.setOnFinished(_ -> clean());
        this.rendering = rendering;
        shownWidth = picture.width();
        wiped = picture.width() / 2;
        shown = picture.radiance();
        ScrollPane scroll = new ScrollPane(view);
        scroll.setPannable(true);
        scroll.getStyleClass().add("help");
        scroll.addEventFilter(ScrollEvent.SCROLL, event -> {
            zoomTo(zoom * (event.getDeltaY() > 0 ? STEP : 1 / STEP));
            event.consume();
        });
        view.setId("viewed");
        view.addEventHandler(MouseEvent.MOUSE_MOVED, event -> {
            tell(event.getX(), event.getY());
            if (compare.modeProperty().get() == Mode.WIPE) {
                wiped = (int) (event.getX() / zoom);
                tone();
            }
        });
        values.setId("viewed-values");
        values.setText(picture.width() + " × " + picture.height());
        double stops = picture.display().exposure();
        exposure.setMin(Math.min(-STOPS, stops));
        exposure.setMax(Math.max(STOPS, stops));
        exposure.setValue(stops);
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
        if (picture.guides().isPresent() || picture.clean().isPresent()) {
            Label label = new Label("Denoise");
            label.getStyleClass().add("row-name");
            label.setLabelFor(denoise);
            denoise.setId("viewed-denoise");
            denoise.setSelected(picture.clean().isPresent());
            denoise.selectedProperty().subscribe((_, _) -> tone());
            HBox row = new HBox(label, denoise);
            row.getStyleClass().add("row");
            controls.getChildren().add(row);
        }
        controls.getChildren().add(compare);
        compare.modeProperty().subscribe((_, now) -> compare(now));
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
            List<Rgb> factors = factors();
            boolean clean = denoise.isSelected();
            Mode mode = compare.modeProperty().get();
            int columns = wiped;
            Optional<Other> second = other;
            tasks.run(
                    () -> {
                        Optional<float[]> known = clean ? denoising.known(factors) : Optional.empty();
                        return toned(known.orElseGet(() -> picture.lit(factors)), stops, mode, columns, second);
                    },
                    this::show,
                    this::complain);
        }
    }

    private List<Rgb> factors() {
        return lights.stream().map(LightControls::factor).toList();
    }

    /** Removes the noise on a thread of its own, as that may take seconds. */
    private void clean() {
        List<Rgb> factors = factors();
        if (denoise.isSelected() && !cleaning && denoising.isDue(factors)) {
            cleaning = true;
            CompletableFuture<float[]> _ = CompletableFuture.supplyAsync(() -> denoising.clean(factors))
                    .whenComplete((_, problem) -> Platform.runLater(() -> endCleaning(Optional.ofNullable(problem))));
        }
    }

    private void endCleaning(Optional<Throwable> problem) {
        cleaning = false;
        if (problem.isPresent()) {
            denoise.setSelected(false);
            values.setText(Dialogs.explain(problem.get().getCause()));
        } else {
            tone();
        }
    }

    private Toned toned(float[] radiance, double stops, Mode mode, int columns, Optional<Other> second) {
        Rendering settings = picture.display().withExposure(stops);
        Optional<Other> same = second.filter(one -> one.width() == picture.width() && one.height() == picture.height());
        if (same.isEmpty()) {
            String apart = second.map(one -> "The rendering has " + one.width() + " × " + one.height()
                            + " pixels; only pictures of the same size are compared. Save one with F12.")
                    .orElse("");
            return new Toned(radiance, picture.width(), TonedPixels.of(radiance, settings), apart);
        }
        ComparedPictures both = new ComparedPictures(
                picture.width(), picture.height(), radiance, same.get().radiance());
        return new Toned(
                mode == Mode.SECOND ? same.get().radiance() : radiance,
                both.width(mode),
                both.pixels(mode, columns, settings),
                String.format(Locale.ROOT, "Root mean square difference: %.4g", both.rootMeanSquare()));
    }

    /** Goes to and fro between the picture and the rendering. */
    void flip() {
        compare.flip();
    }

    private void compare(Mode mode) {
        if (mode != Mode.FIRST && other.isEmpty()) {
            take();
        } else {
            tone();
        }
    }

    /** Takes the window's picture as it is now. */
    private void take() {
        rendering
                .get()
                .ifPresentOrElse(
                        now -> tasks.run(
                                () -> new Other(now.width(), now.height(), now.await()),
                                taken -> {
                                    other = Optional.of(taken);
                                    tone();
                                },
                                this::complain),
                        () -> compare.tell("The window has no picture yet"));
    }

    private void show(Toned toned) {
        shown = toned.radiance();
        shownWidth = toned.width();
        compare.tell(toned.result());
        view.setImage(new WritableImage(new PixelBuffer<>(
                toned.width(), picture.height(), IntBuffer.wrap(toned.argb()), PixelFormat.getIntArgbPreInstance())));
        zoomTo(zoom);
        toning = false;
        if (toneAgain) {
            tone();
        } else {
            rest.playFromStart();
        }
    }

    private void complain(Throwable problem) {
        toning = false;
        values.setText(Dialogs.explain(problem));
    }

    private void zoomTo(double wanted) {
        zoom = Math.clamp(wanted, LEAST_ZOOM, MOST_ZOOM);
        view.setSmooth(zoom < 1);
        view.setFitWidth(shownWidth * zoom);
        view.setFitHeight(picture.height() * zoom);
    }

    private void tell(double x, double y) {
        int column = (int) Math.clamp(x / zoom, 0, shownWidth - 1) % picture.width();
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

    /** The ways to compare the picture of a file with the rendering. */
    private static final class CompareControls extends VBox {
        private final ObjectProperty<Mode> mode = new SimpleObjectProperty<>(Mode.FIRST);
        private final ToggleGroup group = new ToggleGroup();
        private final Label result = new Label();

        /** @param take takes the present rendering */
        CompareControls(Runnable take) {
            getStyleClass().add("rows");
            FlowPane buttons = new FlowPane();
            buttons.getStyleClass().add("compare-modes");
            for (Mode one : Mode.values()) {
                ToggleButton button = new ToggleButton(one.label());
                button.setId("compare-" + Ids.of(one.label()));
                button.setTooltip(Tooltips.of(one.hint()));
                button.setToggleGroup(group);
                button.setOnAction(_ -> {
                    // A click on the chosen one does not take the choice back.
                    button.setSelected(true);
                    mode.set(one);
                });
                mode.subscribe(now -> button.setSelected(now == one));
                buttons.getChildren().add(button);
            }
            Button again = new Button("Take the rendering again");
            again.setId("compare-again");
            again.setTooltip(Tooltips.of("Compares with the window's picture as it is now."));
            again.setOnAction(_ -> take.run());
            result.setId("compare-result");
            result.setWrapText(true);
            getChildren().addAll(new Label("Compare with the rendering"), buttons, again, result);
        }

        ObjectProperty<Mode> modeProperty() {
            return mode;
        }

        /** Goes to and fro between the two pictures. */
        void flip() {
            mode.set(mode.get() == Mode.SECOND ? Mode.FIRST : Mode.SECOND);
        }

        void tell(String text) {
            result.setText(text);
        }
    }
}
