package dev.twister.gui;

import dev.twister.bench.Statistics;
import dev.twister.bench.report.WindowRates;
import dev.twister.engine.auto.FastestEngine;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.ResolutionMode;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Camera;
import dev.twister.scene.Sphere;
import dev.twister.world.animation.CameraPath;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javafx.application.ConditionalFeature;
import javafx.application.Platform;
import javafx.stage.Screen;

/**
 * Moves the camera on a circle around the scene, at 720p, and notes when pictures are shown. Used by JavaFX's thread.
 */
final class CircleMeasurement {
    private static final double TURN_SECONDS = 10;

    /** The chosen engine may compile its kernel for long, or fail and leave the picture to another. */
    private static final double LONGEST_START_SECONDS = 60;

    private static final double NANOS_PER_SECOND = TimeUnit.SECONDS.toNanos(1);

    private final Studio studio;
    private final Camera camera;
    private final List<Sphere> spheres;
    private final double warmUpSeconds;
    private final double seconds;
    private final Consumer<Optional<WindowRates>> whenDone;
    private final long beginNanos = System.nanoTime();
    private final List<Long> shownNanos = new ArrayList<>();
    private Optional<DrawnPicture> first = Optional.empty();
    private Optional<DrawnPicture> last = Optional.empty();
    private int pulses;
    private boolean ready;
    private double movedSince;
    private boolean done;

    /**
     * Begins; {@link #pulse} is to be called in every pulse.
     *
     * @param warmUpSeconds of moving before the first picture that counts
     * @param seconds of the measurement
     * @param whenDone told once; empty where the chosen engine did not start in time, or fewer than two pictures were
     *     shown
     */
    CircleMeasurement(Studio studio, double warmUpSeconds, double seconds, Consumer<Optional<WindowRates>> whenDone) {
        this.studio = studio;
        this.warmUpSeconds = warmUpSeconds;
        this.seconds = seconds;
        this.whenDone = whenDone;
        camera = studio.scene().camera();
        spheres = studio.scene().spheres();
        studio.refiningProperty().set(false);
        studio.setResolution(ResolutionMode.HD);
    }

    void pulse(long startNanos) {
        if (done) {
            return;
        }
        double elapsed = (startNanos - beginNanos) / NANOS_PER_SECOND;
        if (!ready) {
            ready = isReady();
            movedSince = elapsed;
            if (!ready && elapsed > LONGEST_START_SECONDS) {
                finish(Optional.empty());
            }
            return;
        }
        double moved = elapsed - movedSince;
        studio.moveCamera(_ -> CameraPath.onCircle(camera, spheres, moved / TURN_SECONDS));
        if (moved <= warmUpSeconds) {
            return;
        }
        pulses++;
        studio.pictureProperty().get().filter(DrawnPicture::isWhole).ifPresent(picture -> note(picture, startNanos));
        if (moved > warmUpSeconds + seconds) {
            finish(last.filter(_ -> shownNanos.size() > 1).map(this::rates));
        }
    }

    private void finish(Optional<WindowRates> rates) {
        done = true;
        whenDone.accept(rates);
    }

    /** Whether the chosen engine, or the device that a family's name stands for, renders, in the whole size. */
    private boolean isReady() {
        String chosen = studio.engineProperty().get().offer().id();
        return studio.pictureProperty()
                .get()
                .filter(DrawnPicture::isWhole)
                .filter(picture -> picture.engine().equals(chosen)
                        || picture.engine().startsWith(chosen + ":")
                        || chosen.equals(FastestEngine.AUTO))
                .isPresent();
    }

    private void note(DrawnPicture picture, long nanos) {
        if (last.filter(before -> before.number() == picture.number()).isEmpty()) {
            shownNanos.add(nanos);
            first = first.or(() -> Optional.of(picture));
            last = Optional.of(picture);
        }
    }

    private WindowRates rates(DrawnPicture newest) {
        DrawnPicture oldest = first.orElse(newest);
        long[] nanos = new long[shownNanos.size() - 1];
        for (int i = 0; i < nanos.length; i++) {
            nanos[i] = shownNanos.get(i + 1) - shownNanos.get(i);
        }
        Screen screen = Screen.getPrimary();
        return new WindowRates(
                newest.engine(),
                newest.device(),
                studio.scene()
                        .rendering()
                        .withSize(newest.request().width(), newest.request().height()),
                Statistics.ofNanos(nanos),
                (newest.number() - oldest.number())
                        * NANOS_PER_SECOND
                        / Math.max(1, newest.finishedNanos() - oldest.finishedNanos()),
                new WindowRates.Display(
                        (int) screen.getBounds().getWidth(),
                        (int) screen.getBounds().getHeight(),
                        screen.getOutputScaleX(),
                        Platform.isSupported(ConditionalFeature.SCENE3D),
                        pulses / seconds));
    }
}
