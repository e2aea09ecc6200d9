package dev.twister.gui.panel;

import dev.twister.gui.files.AssetActions;
import dev.twister.gui.model.BodyChoices;
import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyMaterials;
import dev.twister.gui.model.BodyNumber;
import dev.twister.gui.studio.Studio;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;

/** What the selected sphere, mesh or plane is made of; not seen where none is selected. */
final class MaterialSection extends VBox {
    private final Studio studio;
    private final AssetActions assets;
    private final Label hint = new Label();
    private final SwitchRow own;
    private int body = BodyNumber.NONE;
    private Optional<MaterialRows> material = Optional.empty();

    MaterialSection(Studio studio, AssetActions assets) {
        this.studio = studio;
        this.assets = assets;
        getStyleClass().add("rows");
        hint.getStyleClass().add("hint");
        hint.setWrapText(true);
        hint.setId("material-hint");
        own = new SwitchRow(
                "Own material",
                "Give the mesh one material. Off: the materials of its file.",
                "Alt+Shift+7",
                this::setOwn);
        studio.selection().activeProperty().subscribe(_ -> rebuild());
        studio.selection().bodiesProperty().subscribe(_ -> refresh());
        studio.sceneProperty().subscribe(_ -> refresh());
    }

    /** The rows of the body that is selected; none where it has no material. */
    List<PanelRow> rows() {
        return Stream.concat(
                        BodyEdits.isMesh(studio.scene(), body) ? Stream.of(own) : Stream.empty(),
                        material.map(MaterialRows::rows).orElse(List.of()).stream())
                .toList();
    }

    private void rebuild() {
        // It would be taken as they lose the focus, for the body that has the number now.
        material.filter(MaterialRows::isRenumbered).ifPresent(MaterialRows::forgetTyped);
        body = studio.selection().active();
        material = Optional.of(body)
                .filter(selected -> BodyMaterials.has(studio.scene(), selected))
                .map(selected -> new MaterialRows(studio, assets, selected));
        setVisible(material.isPresent() || BodyEdits.isMesh(studio.scene(), body));
        getChildren().setAll(hint);
        getChildren().addAll(rows());
        refresh();
    }

    private void refresh() {
        if (body != studio.selection().active()) {
            // The selection follows a scene that has lost the body; until then there is nothing to show.
            return;
        }
        boolean mesh = BodyEdits.isMesh(studio.scene(), body);
        boolean has = BodyMaterials.has(studio.scene(), body);
        if (mesh && has != material.isPresent()) {
            rebuild();
            return;
        }
        own.show(has, false);
        material.filter(_ -> has).ifPresent(rows -> {
            rows.show();
            hint.setText(rows.hint());
        });
        if (mesh && !has) {
            hint.setText(BodyChoices.title(studio.scene(), body) + " has the materials of its file.");
        }
    }

    private void setOwn(boolean on) {
        int mesh = body;
        studio.edit(
                on ? "own material" : "file's materials",
                scene -> on
                        ? BodyMaterials.with(scene, mesh, studio.bodies().fileMaterial(mesh))
                        : BodyMaterials.withFiles(scene, mesh));
        studio.endGesture();
    }
}
