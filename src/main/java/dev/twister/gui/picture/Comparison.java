package dev.twister.gui.picture;

import dev.twister.engine.EngineOffer;
import dev.twister.gui.drawing.DrawingLoop;
import dev.twister.gui.drawing.DrawingRequest;
import dev.twister.gui.drawing.DrawingRequest.EngineChoice;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.studio.Studio;
import dev.twister.image.Frame;
import dev.twister.scene.Rendering;
import dev.twister.world.StageOrView;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleObjectProperty;

/**
 * A second picture of what the first one shows, by another engine, of another stage, or with other settings, and how
 * they differ. It follows the first one, and is drawn on a thread of its own while it is wanted. Used by JavaFX's
 * thread.
 */
public final class Comparison implements AutoCloseable {
    /** To compare pictures takes some milliseconds. */
    private static final long COMPARED_EVERY_NANOS = TimeUnit.MILLISECONDS.toNanos(200);

    private final Studio studio;
    private final Supplier<DrawingLoop> loops;
    private final ObjectProperty<Mode> mode = new SimpleObjectProperty<>(Mode.OFF);
    private final ObjectProperty<Optional<EngineOffer>> engine = new SimpleObjectProperty<>(Optional.empty());
    private final ObjectProperty<Optional<StageOrView>> shown = new SimpleObjectProperty<>(Optional.empty());
    private final ObjectProperty<Optional<Rendering>> settings = new SimpleObjectProperty<>(Optional.empty());
    private final ReadOnlyObjectWrapper<Optional<Other>> other = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final ReadOnlyObjectWrapper<Optional<PictureDifference>> difference =
            new ReadOnlyObjectWrapper<>(Optional.empty());
    private Optional<DrawingLoop> loop = Optional.empty();
    private Optional<DrawingRequest> followed = Optional.empty();
    private EngineChoice choice;
    private long requests;
    private Optional<Pair> compared = Optional.empty();
    private long comparedNanos;

    /** How both are shown. */
    public enum Mode {
        OFF,
        SPLIT,
        DIFFERENCE
    }

    /** The second picture; its pixels stay as they are. */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    record Other(DrawnPicture picture, int[] argb) {}

    /** The numbers of the pictures that have been compared. */
    private record Pair(long first, long second) {}

    public Comparison(Studio studio, Supplier<DrawingLoop> loops) {
        this.studio = studio;
        this.loops = loops;
        choice = studio.engineProperty().get();
        mode.subscribe(this::changeMode);
        engine.subscribe(_ -> followed = Optional.empty());
        shown.subscribe(_ -> followed = Optional.empty());
        settings.subscribe(_ -> followed = Optional.empty());
    }

    public ObjectProperty<Mode> modeProperty() {
        return mode;
    }

    public boolean isOn() {
        return mode.get() != Mode.OFF;
    }

    /** What draws the second picture; empty for what draws the first. */
    public ObjectProperty<Optional<EngineOffer>> engineProperty() {
        return engine;
    }

    /** What the second picture shows; empty for what the first does. */
    public ObjectProperty<Optional<StageOrView>> shownProperty() {
        return shown;
    }

    /** The settings of the second picture; empty for those of the first. */
    public ObjectProperty<Optional<Rendering>> settingsProperty() {
        return settings;
    }

    ReadOnlyObjectProperty<Optional<Other>> otherProperty() {
        return other.getReadOnlyProperty();
    }

    /** How the pictures differ that are shown now; empty until both are there in the same size. */
    public ReadOnlyObjectProperty<Optional<PictureDifference>> differenceProperty() {
        return difference.getReadOnlyProperty();
    }

    /** Called in every pulse. */
    public void pulse(long nanos) {
        loop.ifPresent(drawing -> {
            studio.pictureProperty().get().filter(DrawnPicture::isWhole).ifPresent(first -> follow(first, drawing));
            drawing.takeNewest()
                    .ifPresent(newest -> other.set(
                            Optional.of(new Other(newest, newest.frame().argb().clone()))));
            if (nanos - comparedNanos >= COMPARED_EVERY_NANOS) {
                compare(nanos);
            }
        });
    }

    @Override
    public void close() {
        loop.ifPresent(DrawingLoop::close);
        loop = Optional.empty();
    }

    private void changeMode(Mode now) {
        if (now == Mode.OFF) {
            close();
            other.set(Optional.empty());
            difference.set(Optional.empty());
            compared = Optional.empty();
        } else if (loop.isEmpty()) {
            DrawingLoop started = loops.get();
            started.start();
            loop = Optional.of(started);
            followed = Optional.empty();
        }
    }

    /** After the first picture, so that skies and textures have been read by then. */
    private void follow(DrawnPicture first, DrawingLoop drawing) {
        DrawingRequest leading = first.request();
        if (!followed.equals(Optional.of(leading))) {
            followed = Optional.of(leading);
            requests++;
            EngineOffer offer = engine.get().orElse(leading.engine().offer());
            if (!offer.equals(choice.offer())) {
                choice = new EngineChoice(choice.number() + 1, offer);
            }
            drawing.request(new DrawingRequest(
                    requests,
                    leading.document(),
                    settings.get().map(leading.scene()::withRendering).orElse(leading.scene()),
                    leading.width(),
                    leading.height(),
                    choice,
                    leading.refinement(),
                    leading.motion(),
                    shown.get().orElse(leading.shown())));
        }
    }

    private void compare(long nanos) {
        Optional<DrawnPicture> first = studio.pictureProperty().get();
        Optional<Pair> pair = first.flatMap(one ->
                other.get().map(two -> new Pair(one.number(), two.picture().number())));
        if (pair.isPresent() && !pair.equals(compared)) {
            compared = pair;
            comparedNanos = nanos;
            Frame frame = first.orElseThrow().frame();
            difference.set(other.get()
                    .filter(two ->
                            two.picture().frame().width() == frame.width() && two.argb().length == frame.argb().length)
                    .map(two -> PictureDifference.of(frame.argb(), two.argb(), frame.width())));
        }
    }
}
