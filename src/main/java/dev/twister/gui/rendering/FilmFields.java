package dev.twister.gui.rendering;

import dev.twister.gui.controls.NumberField;
import dev.twister.gui.controls.PlainBox;
import dev.twister.gui.rendering.WindowOrder.FilmMotion;
import dev.twister.gui.rendering.WindowOrder.FilmPlan;
import dev.twister.render.FrameRange;
import dev.twister.scene.Scene;
import dev.twister.scene.property.Range;
import dev.twister.world.Animation;
import dev.twister.world.SceneMeshes;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;

/** The fields of a film: what moves, and which frames are rendered. */
final class FilmFields {
    private static final Range RATES = new Range(0.001, 1000, "frames per second");
    private static final Range NUMBERS = new Range(0, FrameRange.MOST - 1);
    private static final double USUAL_RATE = 30;

    /** Length of a film of moving bodies, which has no end of its own. */
    private static final double USUAL_SECONDS = 10;

    private final Runnable changed;
    private final PlainBox<FilmMotion> motion;
    private final NumberField rate;
    private final NumberField first;
    private final NumberField last;
    private final Label length = new Label();
    private final HBox frames;

    private Optional<Scene> filmed = Optional.empty();
    private SceneMeshes meshes = SceneMeshes.NONE;
    private boolean showing;

    /** Whether the last frame follows the film's own end. */
    private boolean whole = true;

    /** @param changed called when a field changes */
    FilmFields(Runnable changed) {
        this.changed = changed;
        motion = new PlainBox<>("render-motion", FilmMotion::label, this::showEnd);
        rate = new NumberField("Frames per second", RATES, false, this::showEnd);
        first = new NumberField("First frame", NUMBERS, true, this::tell);
        last = new NumberField("Last frame", NUMBERS, true, this::takeLast);
        length.getStyleClass().add("hint");
        length.setId("render-length");
        frames = new HBox(first, new Label("to"), last, length);
        frames.getStyleClass().add("render-fields");
    }

    PlainBox<FilmMotion> motion() {
        return motion;
    }

    NumberField rate() {
        return rate;
    }

    /** The rate, also if there is no film; the default if it is wrong. */
    double framesPerSecond() {
        return rate.complaint().isPresent() ? USUAL_RATE : rate.number();
    }

    HBox frames() {
        return frames;
    }

    NumberField first() {
        return first;
    }

    /** Shows the defaults. */
    void showUsual() {
        first.show(0);
        rate.show(USUAL_RATE);
    }

    /** Discards an end that was typed for another scene. */
    void startAnew() {
        whole = true;
    }

    /**
     * Offers the motions that a scene has.
     *
     * @param shown the scene's meshes
     */
    void follow(Scene scene, SceneMeshes shown) {
        filmed = Optional.of(scene);
        meshes = shown;
        List<FilmMotion> motions = FilmMotion.of(scene);
        motion.offer(motions, motions.stream().findFirst());
        showEnd();
    }

    /** The error message, or why there is no film. */
    Optional<String> complaint() {
        return Optional.of("Nothing moves: set two keyframes or more, or add spheres that fall")
                .filter(_ -> motion.choice().isEmpty())
                .or(rate::complaint)
                .or(first::complaint)
                .or(last::complaint)
                .or(() -> Optional.of("Last frame is " + last.wholeNumber() + ", but must be at least the first frame, "
                                + first.wholeNumber())
                        .filter(_ -> last.number() < first.number()));
    }

    /** The film; empty if {@link #complaint} tells why there is none. */
    Optional<FilmPlan> film() {
        return complaint().isPresent()
                ? Optional.empty()
                : motion.choice().map(moving -> new FilmPlan(moving, rate.number(), range()));
    }

    private FrameRange range() {
        return FrameRange.of(first.wholeNumber(), last.wholeNumber());
    }

    private void takeLast() {
        whole &= showing;
        tell();
    }

    private void showEnd() {
        if (whole && rate.complaint().isEmpty()) {
            showing = true;
            last.show(NUMBERS.clamp(count(rate.number()) - 1));
            showing = false;
        }
        tell();
    }

    private double count(double framesPerSecond) {
        boolean path = motion.choice().filter(FilmMotion::followsKeyframes).isPresent();
        return filmed.filter(scene -> path && Animation.length(scene, meshes) > 0)
                .map(scene -> (double) Animation.frames(scene, meshes, framesPerSecond))
                .orElse(Math.rint(USUAL_SECONDS * framesPerSecond) + 1);
    }

    private void tell() {
        if (!showing) {
            length.setText(film().map(FilmFields::describe).orElse(""));
            changed.run();
        }
    }

    private static String describe(FilmPlan film) {
        int count = film.frames().count();
        return String.format(Locale.ROOT, "%d %s, %.2f s", count, count == 1 ? "frame" : "frames", count / film.rate());
    }
}
