package dev.twister.gui;

import dev.twister.bench.report.WindowRates;
import dev.twister.gui.camera.CameraKeys;
import dev.twister.gui.camera.CameraMouse;
import dev.twister.gui.files.AutosaveFolder;
import dev.twister.gui.files.FileChoice;
import dev.twister.gui.files.Reading;
import dev.twister.gui.files.SettingsStore;
import dev.twister.gui.files.ShippedFolders;
import dev.twister.gui.panel.PanelWindow;
import dev.twister.gui.picture.FrameTimesView;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.studio.Studio;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
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
    private final HeapMonitor heap;
    private final Reading reading = new Reading();
    private final Workbench workbench;
    private final Pulses pulses;
    private final Runnable afterLayout;
    private long pulseNanos;
    private PulseListener listener = (_, _) -> {};

    /**
     * The dependencies of a window.
     *
     * @param files the file dialogs
     * @param settings the store of the window's settings
     * @param found the settings read from the store
     * @param autosaves the store of unsaved edits
     * @param shipped the scenes that are offered and never overwritten
     * @param asked the scene's file, if the user named it
     * @param textScale how much larger than usual text is, above 0
     * @param heap the monitor of the heap, told of each pulse
     */
    record Options(
            FileChoice files,
            SettingsStore settings,
            SettingsStore.Found found,
            AutosaveFolder autosaves,
            ShippedFolders shipped,
            Optional<Path> asked,
            double textScale,
            HeapMonitor heap) {}

    /**
     * Told of each pulse when it began and when the interface's thread was done with it, by {@link System#nanoTime}.
     */
    @FunctionalInterface
    interface PulseListener {
        void pulsed(long startNanos, long endNanos);
    }

    MainWindow(Stage stage, Studio studio, Options options) {
        this.stage = stage;
        this.studio = studio;
        heap = options.heap();
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

    /**
     * Has garbage collected before the heap has grown to many times what lives in it: the JVM lets it grow up to most
     * of the computer's memory, which is there for large scenes. Used by JavaFX's thread.
     */
    static final class HeapMonitor {
        /** Heaps smaller than this are left to the JVM. */
        static final long SMALL_BYTES = 400L << 20;

        /** The factor of growth at which garbage is collected even while the user works and would notice the pause. */
        private static final double LATEST = 1.5;

        /** The factor of growth at which at least half of the heap is garbage. */
        private static final double GROWTH = 2;

        private static final long LOOK_NANOS = TimeUnit.SECONDS.toNanos(1);

        private final LongSupplier usedBytes;
        private final Runnable collect;
        private volatile boolean collecting;
        private volatile long livingBytes;
        private long lookedNanos;

        /** A monitor of this JVM's heap. */
        HeapMonitor() {
            this(() -> Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory(), System::gc);
        }

        /**
         * A monitor of another heap than this JVM's.
         *
         * @param usedBytes the used part of the heap, garbage included
         * @param collect returns when that is collected
         */
        HeapMonitor(LongSupplier usedBytes, Runnable collect) {
            this.usedBytes = usedBytes;
            this.collect = collect;
        }

        /**
         * Called in every pulse.
         *
         * @param resting whether nothing is drawn, so that a pause is not noticed
         * @return the task that collects, if collecting is due
         */
        Optional<Thread> pulse(long nanos, boolean resting) {
            if (collecting || nanos - lookedNanos < LOOK_NANOS) {
                return Optional.empty();
            }
            lookedNanos = nanos;
            double due = Math.max(SMALL_BYTES, GROWTH * livingBytes);
            if (usedBytes.getAsLong() <= (resting ? due : LATEST * due)) {
                return Optional.empty();
            }
            collecting = true;
            return Optional.of(Thread.ofPlatform().daemon().name("garbage").start(() -> {
                collect.run();
                livingBytes = usedBytes.getAsLong();
                collecting = false;
            }));
        }
    }
}
