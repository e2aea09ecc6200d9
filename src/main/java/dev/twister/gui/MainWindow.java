package dev.twister.gui;

import dev.twister.bench.report.WindowRates;
import dev.twister.gui.camera.CameraKeys;
import dev.twister.gui.camera.CameraMouse;
import dev.twister.gui.files.Reading;
import dev.twister.gui.panel.PanelWindow;
import dev.twister.gui.picture.FrameTimesView;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.studio.Studio;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javafx.geometry.Pos;
import javafx.scene.Scene;
import javafx.scene.input.InputEvent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.StackPane;
import javafx.scene.paint.Color;
import javafx.stage.Stage;

/** The window: the picture in the center, with the menu, panel and status line around it. */
public final class MainWindow implements AutoCloseable {
    private static final double WIDTH = 1280;
    private static final double HEIGHT = 760;
    private static final double WARM_UP_SECONDS = 5;
    private static final double MEASURED_SECONDS = 10;

    /**
     * Painted with the clearing of the window: a background under the picture would be a second coat, which takes
     * JavaFX without a graphics card a quarter of a picture's time.
     */
    private static final Color AROUND_THE_PICTURE = Color.web("#101113");

    private static final double NANOS_PER_MILLI = TimeUnit.MILLISECONDS.toNanos(1);

    private final Stage stage;
    private final Studio studio;
    private final PictureView picture;
    private final FrameTimesView frameTimes;
    private final StatusLine status;
    private final HeapMonitor heap = new HeapMonitor();
    private final Reading reading = new Reading();
    private final Workbench workbench;
    private final Pulses pulses;
    private final Runnable afterLayout;
    private long pulseNanos;
    private PulseListener listener = (_, _) -> {};

    /**
     * Told of each pulse when it began and when the interface's thread was done with it, by {@link System#nanoTime}.
     */
    @FunctionalInterface
    interface PulseListener {
        void pulsed(long startNanos, long endNanos);
    }

    MainWindow(Stage stage, Studio studio, WindowOptions options) {
        this.stage = stage;
        this.studio = studio;
        picture = new PictureView(studio);
        frameTimes = new FrameTimesView(studio, picture.widthProperty());
        StackPane middle = new StackPane(picture, frameTimes);
        StackPane.setAlignment(frameTimes, Pos.TOP_LEFT);
        // Large text in the panel takes the room from the picture, not from itself.
        middle.setMinSize(0, 0);
        BorderPane root = new BorderPane(middle);
        root.setId("window");
        status = new StatusLine(studio, reading);
        root.setBottom(status);
        Scene scene = new Scene(root, WIDTH, HEIGHT, AROUND_THE_PICTURE);
        scene.getStylesheets().add(MainWindow.class.getResource("twister.css").toExternalForm());
        if (options.textScale() != TextScale.USUAL) {
            scene.getStylesheets().add(TextScale.styleSheet(options.textScale()));
        }
        stage.setScene(scene);
        status.clearAtNextAction(scene);
        CameraKeys keys = CameraKeys.install(scene, studio);
        keys.releaseWithout(stage.focusedProperty());
        AltKey.install(scene);
        CameraMouse.install(picture, studio);
        workbench = new Workbench(stage, root, middle, picture, frameTimes, studio, reading, options);
        status.add(workbench.renderStatus());
        workbench.qUpProperty().subscribe(keys::setQUp);
        pulses = new Pulses(this::pulse, () -> studio.isBusy() || workbench.isBusy());
        scene.addEventFilter(InputEvent.ANY, _ -> pulses.wake());
        PanelWindow aside = workbench.panelWindow();
        status.clearAtNextAction(aside.scene());
        keys.releaseWithout(aside.focusedProperty());
        aside.scene().addEventFilter(InputEvent.ANY, _ -> pulses.wake());
        stage.focusedProperty().subscribe(_ -> pulses.wake());
        afterLayout = this::endPulse;
        scene.addPostLayoutPulseListener(afterLayout);
    }

    /** What reads the files that are opened. */
    public Reading reading() {
        return reading;
    }

    Workbench workbench() {
        return workbench;
    }

    void show() {
        stage.show();
        picture.requestFocus();
        pulses.wake();
    }

    private void pulse() {
        pulseNanos = System.nanoTime();
        picture.tellSize();
        studio.pulse(pulseNanos);
        frameTimes.refresh(pulseNanos);
        workbench.pulse(pulseNanos);
        status.pulse(pulseNanos);
        heap.pulse(pulseNanos, studio.restingSamples().isPresent());
    }

    /** Up to the end of the layout; what the graphics card's thread does comes after that. */
    private void endPulse() {
        long end = System.nanoTime();
        studio.noteDisplayMillis((end - pulseNanos) / NANOS_PER_MILLI);
        listener.pulsed(pulseNanos, end);
    }

    void onPulse(PulseListener newListener) {
        pulses.wake();
        listener = newListener;
    }

    /** Measures how fast the window is, tells that, and closes it. */
    void measure(Consumer<Optional<WindowRates>> whenDone) {
        CircleMeasurement measurement = new CircleMeasurement(studio, WARM_UP_SECONDS, MEASURED_SECONDS, rates -> {
            whenDone.accept(rates);
            stage.hide();
        });
        onPulse((start, _) -> {
            pulses.wake();
            measurement.pulse(start);
        });
    }

    /** Ends all that is the window's but {@linkplain #awaitFiles what is still being written}. */
    @Override
    public void close() {
        pulses.close();
        stage.getScene().removePostLayoutPulseListener(afterLayout);
        workbench.close();
        studio.close();
    }

    /** See {@link Workbench#awaitFiles}. */
    void awaitFiles() {
        workbench.awaitFiles();
    }

    /** Keeps an Alt that was held for the mouse from leading to the menu when it is let go. */
    private static final class AltKey {
        private boolean usedByMouse;

        private AltKey() {}

        static void install(Scene scene) {
            AltKey alt = new AltKey();
            scene.addEventFilter(MouseEvent.MOUSE_PRESSED, event -> alt.usedByMouse |= event.isAltDown());
            scene.addEventFilter(ScrollEvent.SCROLL, event -> alt.usedByMouse |= event.isAltDown());
            scene.addEventFilter(KeyEvent.KEY_PRESSED, _ -> alt.usedByMouse = false);
            scene.addEventFilter(KeyEvent.KEY_RELEASED, event -> {
                if (event.getCode() == KeyCode.ALT && alt.usedByMouse) {
                    event.consume();
                }
            });
        }
    }
}
