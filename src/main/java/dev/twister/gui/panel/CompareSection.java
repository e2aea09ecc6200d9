package dev.twister.gui.panel;

import dev.twister.engine.EngineOffer;
import dev.twister.gui.drawing.StagesAndViews;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.picture.Comparison;
import dev.twister.gui.picture.Comparison.Mode;
import dev.twister.gui.studio.EngineList;
import dev.twister.gui.studio.Studio;
import dev.twister.world.StageOrView;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** Settings of the second picture. */
final class CompareSection {
    private static final String SAME = "as the first";

    private final Studio studio;
    private final EngineList engines;
    private final Comparison comparison;
    private final ChoiceRow<Mode> mode;
    private final ChoiceRow<String> engine;
    private final ChoiceRow<Optional<StageOrView>> shown;
    private final SwitchRow settings;

    CompareSection(Studio studio, EngineList engines, Comparison comparison) {
        this.studio = studio;
        this.engines = engines;
        this.comparison = comparison;
        mode = new ChoiceRow<>(
                "Second picture",
                "Shows a second picture to the right of a divider, or the difference of both, 16 times as bright.",
                "Alt+Shift+B",
                now -> new Look(now.name().toLowerCase(Locale.ROOT)),
                comparison.modeProperty()::set,
                studio::notice);
        engine = new ChoiceRow<>(
                "Its engine",
                "The engine of the second picture.",
                "Alt+Shift+G",
                this::look,
                id -> comparison.engineProperty().set(engines.find(id)),
                studio::notice);
        shown = new ChoiceRow<>(
                "It shows",
                "The stage or view of the second picture.",
                "Alt+Shift+S",
                picture -> new Look(picture.map(StagesAndViews::label).orElse(SAME)),
                comparison.shownProperty()::set,
                studio::notice);
        settings = new SwitchRow(
                "Keep settings",
                "The second picture keeps the settings under Picture as they are now, while you change those of the first.",
                "Alt+Shift+K",
                this::keep);
        engines.offersProperty().subscribe(_ -> refresh());
        comparison.modeProperty().subscribe(_ -> refresh());
        comparison.engineProperty().subscribe(_ -> refresh());
        comparison.shownProperty().subscribe(_ -> refresh());
        comparison.settingsProperty().subscribe(_ -> refresh());
    }

    List<PanelRow> rows() {
        return List.of(mode, engine, shown, settings);
    }

    private void keep(boolean on) {
        comparison.settingsProperty().set(on ? Optional.of(studio.scene().rendering()) : Optional.empty());
    }

    private void refresh() {
        mode.show(List.of(Mode.values()), comparison.modeProperty().get(), Mode.OFF);
        engine.show(
                Stream.concat(
                                Stream.of(SAME),
                                engines.offersProperty().get().stream().map(EngineOffer::id))
                        .toList(),
                comparison.engineProperty().get().map(EngineOffer::id).orElse(SAME),
                SAME);
        shown.show(
                Stream.concat(
                                Stream.of(Optional.<StageOrView>empty()),
                                StagesAndViews.all().stream().map(Optional::of))
                        .toList(),
                comparison.shownProperty().get(),
                Optional.empty());
        settings.show(comparison.settingsProperty().get().isPresent(), false);
    }

    private Look look(String id) {
        return engines.find(id)
                .map(offer -> new Look(id, id, offer.description(), offer.obstacle()))
                .orElseGet(() -> new Look(id));
    }
}
