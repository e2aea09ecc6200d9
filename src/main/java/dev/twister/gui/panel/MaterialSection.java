package dev.twister.gui.panel;

import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.BodyTitles;
import dev.twister.gui.files.AssetActions;
import dev.twister.gui.studio.Studio;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;

/** The material of the selected sphere, mesh or plane; hidden if none is selected. */
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
                "Give the mesh one material. Off: the materials of its file, or the default.",
                "Alt+Shift+7",
                this::setOwn);
        studio.selection().activeProperty().subscribe(_ -> rebuild());
        studio.selection().bodiesProperty().subscribe(_ -> refresh());
        studio.sceneProperty().subscribe(_ -> refresh());
    }

    /** The rows of the selected body; empty if it has no material. */
    List<PanelRow> rows() {
        return Stream.concat(
                        BodyEdits.isMesh(studio.scene(), body) ? Stream.of(own) : Stream.empty(),
                        material.map(MaterialRows::rows).orElse(List.of()).stream())
                .toList();
    }

    private void rebuild() {
        // A field that loses the focus enters its text, now for the body that has taken over the number.
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
            // The body is gone, but the selection has not been updated yet.
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
            hint.setText(BodyTitles.title(studio.scene(), body)
                    + (BodyEdits.mesh(studio.scene(), body).file().isPresent()
                            ? " has the materials of its file."
                            : " has the default material."));
        }
    }

    private void setOwn(boolean on) {
        int mesh = body;
        studio.editOnce(
                on ? "own material" : "file's materials",
                scene -> on
                        ? BodyMaterials.with(scene, mesh, studio.bodies().fileMaterial(mesh))
                        : BodyMaterials.withFiles(scene, mesh));
    }
}
