package dev.twister.gui.panel;

import dev.twister.gui.controls.Ids;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.files.FileNames;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.scene.property.Row;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.control.Button;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.layout.StackPane;

/** A row to choose an image, with a small copy of it. */
final class ImageRow {
    private static final double SIDE = 22;

    private final ChoiceRow<Optional<Path>> row;
    private final ImageView thumbnail = new ImageView();
    private Optional<Path> pictured = Optional.empty();

    /**
     * What the row does.
     *
     * @param use called with the file that a person has chosen
     * @param remove called when none was chosen
     * @param ask asks for a file, and hands it on
     * @param complain shows a message
     */
    record Actions(Consumer<Path> use, Runnable remove, Consumer<Consumer<Path>> ask, Consumer<String> complain) {}

    ImageRow(Row text, Actions actions) {
        row = new ChoiceRow<>(
                text.label(),
                text.hint(),
                text.keys(),
                file -> {
                    String name = file.map(FileNames::name).orElse("None");
                    return new Look(name, name, file.map(Path::toString).orElse(""), Optional.empty());
                },
                file -> file.ifPresentOrElse(actions.use(), actions.remove()),
                actions.complain());
        thumbnail.setFitWidth(SIDE);
        thumbnail.setFitHeight(SIDE);
        thumbnail.setPreserveRatio(true);
        row.addControl(new StackPane(thumbnail));
        Button other = new Button("Other…");
        other.setId("other-" + Ids.of(text.label()));
        other.setTooltip(Tooltips.of("Chooses an image file: .png, .jpg or .webp."));
        other.setOnAction(_ -> actions.ask().accept(actions.use()));
        row.addControl(other);
    }

    PanelRow row() {
        return row;
    }

    void show(List<Optional<Path>> files, Optional<Path> chosen, Optional<Path> usual) {
        row.show(files, chosen, usual);
        if (!chosen.equals(pictured)) {
            pictured = chosen;
            // In the background, and empty where JavaFX does not know the format.
            thumbnail.setImage(
                    chosen.map(file -> new Image(file.toUri().toString(), 2 * SIDE, 2 * SIDE, true, true, true))
                            .orElse(null));
        }
        thumbnail.setManaged(chosen.isPresent());
    }
}
