package dev.twister.gui;

import dev.twister.gui.model.BodyMaterials;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;

/** What the selected sphere or the plane is made of; not seen where neither is selected. */
final class MaterialSection extends VBox {
    private final Studio studio;
    private final FileActions files;
    private final Label hint = new Label();
    private Optional<MaterialRows> material = Optional.empty();

    MaterialSection(Studio studio, FileActions files) {
        this.studio = studio;
        this.files = files;
        getStyleClass().add("rows");
        hint.getStyleClass().add("hint");
        hint.setWrapText(true);
        hint.setId("material-hint");
        studio.selectionProperty().subscribe(_ -> rebuild());
        studio.sceneProperty().subscribe(_ -> refresh());
    }

    /** The rows of the body that is selected; none where it has no material. */
    List<PanelRow> rows() {
        return material.map(MaterialRows::rows).orElse(List.of());
    }

    private void rebuild() {
        int spheres = studio.scene().spheres().size();
        // It would be taken as they lose the focus, for the sphere that has the number now.
        material.filter(old -> old.spheres() != spheres).ifPresent(MaterialRows::forgetTyped);
        int body = studio.selectionProperty().get();
        material = Optional.of(body)
                .filter(selected -> BodyMaterials.has(studio.scene(), selected))
                .map(selected -> new MaterialRows(studio, files, selected));
        setVisible(material.isPresent());
        getChildren().setAll(hint);
        getChildren().addAll(rows());
        refresh();
    }

    private void refresh() {
        // The selection follows a scene that has lost the sphere; until then there is nothing to show.
        material.filter(rows -> BodyMaterials.has(studio.scene(), rows.body())).ifPresent(rows -> {
            rows.show();
            hint.setText(rows.hint());
        });
    }
}
