package dev.twister.gui.panel;

import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.Property;
import java.util.List;
import javafx.scene.control.Button;
import javafx.scene.layout.HBox;

/** Size and height of the plane. */
final class PlaneSection {
    private final List<PropertyRow> rows;
    private final HBox buttons;

    PlaneSection(Studio studio) {
        rows = PropertyRow.of(Property.within(BodyProperties.PLANE, Scene::ground, Scene::withGround), studio);
        Button select = new Button("Colors and material…");
        select.setId("select-plane");
        select.setTooltip(Tooltips.of("Selects the plane, so that Material shows its colors and reflectivity."));
        select.setOnAction(_ -> studio.selection().select(BodyNumber.PLANE));
        buttons = new HBox(select);
        buttons.getStyleClass().add("buttons");
        studio.sceneProperty()
                .subscribe(scene ->
                        rows.forEach(row -> row.show(scene, studio.document().original())));
        studio.document()
                .originalProperty()
                .subscribe(original -> rows.forEach(row -> row.show(studio.scene(), original)));
    }

    List<PanelRow> rows() {
        return rows.stream().map(PropertyRow::row).toList();
    }

    HBox buttons() {
        return buttons;
    }
}
