package dev.twister.gui.panel;

import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.files.AssetActions;
import dev.twister.gui.model.DaylightFile;
import dev.twister.gui.model.DaylightNumbers;
import dev.twister.gui.model.SceneNumbers;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.scene.control.Button;

/** What is behind everything. */
final class SkySection {
    private final Studio studio;
    private final ChoiceRow<Path> sky;
    private final List<NumberRow> numbers;
    private final List<NumberRow> daylight;
    private final Button other = new Button("Other…");
    private List<Path> known = List.of();

    SkySection(Studio studio, AssetActions assets) {
        this.studio = studio;
        sky = new ChoiceRow<>(
                "Sky",
                "The panorama behind everything, which mirrors show too. A file can be dropped on the window.",
                "Alt+K",
                file -> new Look(SkyList.label(file), SkyList.label(file), file.toString(), Optional.empty()),
                file -> assets.useSky(file, this::refresh),
                studio::notice);
        other.setId("other-sky");
        other.setTooltip(Tooltips.of("Chooses a panorama's file: .hdr, .exr, .png or .jpg."));
        other.setOnAction(_ -> assets.chooseSky());
        sky.addControl(other);
        numbers = NumberRow.of(SceneNumbers.SKY, studio);
        daylight = NumberRow.of(DaylightNumbers.ALL, studio);
        studio.sceneProperty().subscribe(_ -> refresh());
        studio.document().originalProperty().subscribe(_ -> refresh());
    }

    /** Offers these panoramas too. */
    void offer(List<Path> panoramas) {
        known = panoramas;
        refresh();
    }

    List<PanelRow> rows() {
        return Stream.of(List.of(sky), numbers, daylight)
                .<PanelRow>flatMap(List::stream)
                .toList();
    }

    private void refresh() {
        Path used = studio.scene().sky().file();
        Path own = studio.document().original().sky().file();
        sky.show(SkyList.with(known, own, used), used, own);
        Scene usual = studio.document().original();
        numbers.forEach(row -> row.show(studio.scene(), usual));
        // A reset of these must not replace a sky of another kind.
        boolean replaced = DaylightFile.of(used).isEmpty();
        daylight.forEach(row -> row.show(studio.scene(), replaced ? studio.scene() : usual));
    }
}
