package dev.twister.gui.panel;

import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.property.SceneNumbers;
import dev.twister.gui.studio.Studio;
import java.util.List;
import javafx.scene.control.Button;
import javafx.scene.layout.HBox;

/** Size and height of the plane. */
final class PlaneSection {
    private final List<NumberRow> numbers;
    private final HBox buttons;

    PlaneSection(Studio studio) {
        numbers = NumberRow.of(SceneNumbers.PLANE, studio);
        Button select = new Button("Colors and material…");
        select.setId("select-plane");
        select.setTooltip(Tooltips.of("Selects the plane, so that Material shows its colors and reflectivity."));
        select.setOnAction(_ -> studio.selection().select(BodyNumber.PLANE));
        buttons = new HBox(select);
        buttons.getStyleClass().add("buttons");
        studio.sceneProperty()
                .subscribe(scene ->
                        numbers.forEach(row -> row.show(scene, studio.document().original())));
        studio.document()
                .originalProperty()
                .subscribe(original -> numbers.forEach(row -> row.show(studio.scene(), original)));
    }

    List<PanelRow> rows() {
        return List.copyOf(numbers);
    }

    HBox buttons() {
        return buttons;
    }
}
