package dev.twister.gui.files;

import dev.twister.gui.studio.Studio;
import dev.twister.scene.property.SceneLimits;
import dev.twister.scene.select.Title;
import javafx.scene.control.ButtonType;
import javafx.scene.control.Dialog;
import javafx.scene.control.DialogPane;
import javafx.scene.control.Label;
import javafx.scene.control.TextArea;
import javafx.scene.control.TextField;
import javafx.scene.control.TextFormatter;
import javafx.scene.layout.GridPane;
import javafx.stage.Stage;

/** Edits a scene's name and description. */
public final class TitleDialog {
    private static final int COLUMNS = 36;
    private static final int ROWS = 4;

    private TitleDialog() {}

    public static void show(Stage owner, Studio studio) {
        Title title = studio.scene().title();
        TextField name = new TextField(title.name());
        name.setId("title-name");
        name.setPrefColumnCount(COLUMNS);
        name.setTextFormatter(limited(SceneLimits.MAX_NAME_LENGTH));
        TextArea description = new TextArea(title.description());
        description.setId("title-description");
        description.setPrefColumnCount(COLUMNS);
        description.setPrefRowCount(ROWS);
        description.setWrapText(true);
        description.setTextFormatter(limited(SceneLimits.MAX_DESCRIPTION_LENGTH));
        GridPane form = new GridPane();
        form.getStyleClass().add("render-form");
        form.addRow(0, label("_Name", name), name);
        form.addRow(1, label("_Description", description), description);
        Dialog<ButtonType> dialog = new Dialog<>();
        dialog.initOwner(owner);
        dialog.setTitle("Name and description");
        DialogPane pane = dialog.getDialogPane();
        pane.setId("title-dialog");
        pane.getStylesheets().setAll(owner.getScene().getStylesheets());
        pane.setContent(form);
        pane.getButtonTypes().setAll(ButtonType.OK, ButtonType.CANCEL);
        dialog.setOnShown(_ -> name.requestFocus());
        dialog.setOnHidden(_ -> {
            if (ButtonType.OK.equals(dialog.getResult())) {
                Title entered =
                        new Title(name.getText().strip(), description.getText().strip());
                studio.editOnce("name and description", scene -> scene.withTitle(entered));
            }
        });
        dialog.show();
    }

    private static Label label(String text, javafx.scene.Node control) {
        Label label = new Label(text);
        label.setMnemonicParsing(true);
        label.setLabelFor(control);
        control.setAccessibleText(text.replace("_", ""));
        return label;
    }

    private static TextFormatter<String> limited(int letters) {
        return new TextFormatter<>(change -> change.getControlNewText().length() <= letters ? change : null);
    }
}
