package dev.twister.gui.panel;

import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.files.AssetActions;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.property.DaylightFile;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneProperties;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.scene.control.Button;

/** What is behind everything. */
final class SkySection {
    private final Studio studio;
    private final ChoiceRow<Path> sky;
    private final List<PanelRow> rows;
    private final List<NumberRow> daylight;
    private final Button other = new Button("Other…");
    private List<Path> known = List.of();

    SkySection(Studio studio, AssetActions assets) {
        this.studio = studio;
        sky = new ChoiceRow<>(
                "Sky",
                "The panorama behind everything, which mirrors show too. A file can be dropped on the window.",
                "Alt+K",
                file -> new Look(label(file), label(file), file.toString(), Optional.empty()),
                file -> assets.useSky(file, this::refresh),
                studio::notice);
        other.setId("other-sky");
        other.setTooltip(Tooltips.of("Chooses a panorama's file: .hdr, .exr, .png or .jpg."));
        other.setOnAction(_ -> assets.chooseSky());
        sky.addControl(other);
        rows = PropertyRow.following(Property.within(SceneProperties.SKY, Scene::sky, Scene::withSky), studio);
        daylight = NumberRow.of(DaylightFile.NUMBERS, studio);
        studio.sceneProperty().subscribe(_ -> refresh());
        studio.document().originalProperty().subscribe(_ -> refresh());
    }

    /** Offers these panoramas too. */
    void offer(List<Path> panoramas) {
        known = panoramas;
        refresh();
    }

    List<PanelRow> rows() {
        return Stream.of(Stream.of(sky), rows.stream(), daylight.stream())
                .<PanelRow>flatMap(all -> all)
                .toList();
    }

    private void refresh() {
        Path used = studio.scene().sky().file();
        Path own = studio.document().original().sky().file();
        sky.show(Stream.concat(known.stream(), Stream.of(own, used)).distinct().toList(), used, own);
        Scene usual = studio.document().original();
        // A reset of these must not replace a sky of another kind.
        boolean replaced = DaylightFile.of(used).isEmpty();
        daylight.forEach(row -> row.show(studio.scene(), replaced ? studio.scene() : usual));
    }

    /** What a list shows: the file's name without its ending. */
    private static String label(Path panorama) {
        return DaylightFile.of(panorama).isPresent()
                ? "Daylight"
                : String.valueOf(panorama.getFileName()).replaceFirst("\\.[A-Za-z]+$", "");
    }
}
