package dev.twister.gui.studio;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.auto.FastestEngine;
import dev.twister.gui.drawing.DrawnPicture;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.util.Subscription;

/**
 * The engines to choose from: those of the JVM at once, devices later. Looking for devices takes TornadoVM a second of
 * processor time, which compilation needs at the start.
 */
public final class EngineList {
    private final Studio studio;
    private final BackgroundTasks tasks;
    private final ReadOnlyObjectWrapper<List<EngineOffer>> offers;
    private Subscription waiting = Subscription.EMPTY;
    private boolean wanted;
    private boolean looked;

    private EngineList(Studio studio, BackgroundTasks tasks) {
        this.studio = studio;
        this.tasks = tasks;
        EngineOffer first = studio.engineProperty().get().offer();
        List<EngineOffer> atOnce = workableFirst(Engines.offersAtOnce());
        offers = new ReadOnlyObjectWrapper<>(Stream.concat(
                        atOnce.stream(),
                        Stream.of(first)
                                .filter(offer -> atOnce.stream()
                                        .noneMatch(other -> other.id().equals(offer.id()))))
                .toList());
    }

    /** Looks for devices once the first picture rests, or earlier if they are {@link #want wanted}. */
    public static EngineList load(Studio studio, BackgroundTasks tasks) {
        EngineList list = new EngineList(studio, tasks);
        list.waiting = Subscription.combine(
                studio.pictureProperty().subscribe(_ -> list.look()),
                studio.drawingProperty().subscribe(_ -> list.look()));
        return list;
    }

    public ReadOnlyObjectProperty<List<EngineOffer>> offersProperty() {
        return offers.getReadOnlyProperty();
    }

    /** The engine of that id. */
    public Optional<EngineOffer> find(String id) {
        return offers.get().stream().filter(offer -> offer.id().equals(id)).findFirst();
    }

    /** Looks for devices now, because the user opens the list. */
    public void want() {
        wanted = true;
        look();
    }

    /** Not while an engine is being opened: two threads must not start TornadoVM at once. */
    private void look() {
        Optional<DrawnPicture> picture = studio.pictureProperty().get();
        boolean due = picture.filter(seen -> wanted || rests(seen)).isPresent();
        if (due && !looked && studio.drawingProperty().get().opening().isEmpty()) {
            looked = true;
            waiting.unsubscribe();
            tasks.run(() -> workableFirst(Engines.offers()), offers::set, problem -> studio.notice(problem.toString()));
        }
    }

    /** Sorts available engines first, and among them the usual one. */
    static List<EngineOffer> workableFirst(List<EngineOffer> offers) {
        return offers.stream()
                .sorted(Comparator.comparing(
                                (EngineOffer offer) -> offer.obstacle().isPresent())
                        .thenComparing(offer -> !offer.id().equals(FastestEngine.AUTO)))
                .toList();
    }

    private static boolean rests(DrawnPicture picture) {
        return !picture.request().isContinuous() && picture.gathered().isDone();
    }
}
