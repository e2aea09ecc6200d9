package dev.twister.gui.panel;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.gui.drawing.ResolutionMode;
import dev.twister.gui.drawing.StagesAndViews;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.studio.EngineList;
import dev.twister.gui.studio.Studio;
import dev.twister.world.StageOrView;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The engine, the resolution and the shown stage or view. */
final class EngineSection {
    private final Studio studio;
    private final EngineList engines;
    private final ChoiceRow<String> engine;
    private final ChoiceRow<ResolutionMode> resolution;
    private final ChoiceRow<StageOrView> shown;
    private final String usualEngine;

    EngineSection(Studio studio, EngineList engines, String usualEngine) {
        this.studio = studio;
        this.engines = engines;
        this.usualEngine = usualEngine;
        engine = new ChoiceRow<>(
                "Engine",
                "The engine that renders. Engines that do not work here say why.",
                "Alt+G",
                this::look,
                id -> engines.find(id).ifPresent(studio::chooseEngine),
                studio::notice);
        resolution = new ChoiceRow<>(
                "Resolution",
                "Pixels to render; the picture is scaled to fit the window.",
                "Alt+R",
                mode -> new Look(mode.label()),
                studio::setResolution,
                studio::notice);
        shown = new ChoiceRow<>(
                "Show",
                "The full picture, a stage on the way to it, or values per pixel.",
                "Alt+J",
                picture -> new Look(
                        StagesAndViews.label(picture),
                        StagesAndViews.label(picture),
                        StagesAndViews.hint(picture),
                        Optional.empty()),
                studio::setShown,
                studio::notice);
        engine.firstControl().focusedProperty().subscribe(focused -> {
            if (focused) {
                engines.want();
            }
        });
        engines.offersProperty().subscribe(_ -> refresh());
        studio.engineProperty().subscribe(_ -> refresh());
        studio.resolutionProperty().subscribe(_ -> refresh());
        studio.shownProperty().subscribe(now -> shown.show(StagesAndViews.all(), now, StageOrView.BEAUTY));
    }

    List<PanelRow> rows() {
        return List.of(engine, resolution, shown);
    }

    private void refresh() {
        String chosen = studio.engineProperty().get().offer().id();
        List<String> ids = Stream.concat(
                        engines.offersProperty().get().stream().map(EngineOffer::id), Stream.of(chosen))
                .distinct()
                .toList();
        engine.show(ids, chosen, ids.contains(usualEngine) ? usualEngine : chosen);
        resolution.show(
                List.of(ResolutionMode.values()), studio.resolutionProperty().get(), ResolutionMode.WINDOW);
    }

    private Look look(String id) {
        return engines.find(id)
                .map(offer -> new Look(
                        offer.device().isEmpty() ? id : id + " (" + offer.device() + ")",
                        id,
                        offer.description(),
                        offer.obstacle()))
                .orElseGet(() -> unknown(id));
    }

    /**
     * An engine that was asked for by a name that is not in the list: the first device of a family, or one that does
     * not exist.
     */
    private static Look unknown(String id) {
        return Engines.deviceFamilies().contains(id)
                ? new Look(id)
                : new Look(id, id, "", Optional.of("there is no engine of this name here"));
    }
}
