package dev.twister.gui;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.util.Subscription;

/** The engines that a person can choose from. Looking for devices takes TornadoVM a second, so that is an errand. */
final class EngineList {
    private final ReadOnlyObjectWrapper<List<EngineOffer>> offers;
    private Subscription waiting = Subscription.EMPTY;

    private EngineList(EngineOffer first) {
        offers = new ReadOnlyObjectWrapper<>(List.of(first));
    }

    /** The engine in use, and once that is ready, all others too: two threads do not start TornadoVM at once. */
    static EngineList load(Studio studio, Errands errands) {
        EngineList list = new EngineList(studio.engineProperty().get().offer());
        list.waiting = studio.pictureProperty().subscribe(picture -> {
            if (picture.isPresent() && studio.drawingProperty().get().opening().isEmpty()) {
                list.waiting.unsubscribe();
                errands.run(Engines::offers, list.offers::set, problem -> studio.notice(problem.toString()));
            }
        });
        return list;
    }

    ReadOnlyObjectProperty<List<EngineOffer>> offersProperty() {
        return offers.getReadOnlyProperty();
    }

    /** The engine of that name, where there is one. */
    Optional<EngineOffer> find(String id) {
        return offers.get().stream().filter(offer -> offer.id().equals(id)).findFirst();
    }
}
