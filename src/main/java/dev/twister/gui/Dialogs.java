package dev.twister.gui;

import java.util.List;
import javafx.scene.control.Alert;
import javafx.scene.control.Alert.AlertType;
import javafx.scene.control.ButtonBar.ButtonData;
import javafx.scene.control.ButtonType;
import javafx.scene.control.DialogPane;
import javafx.stage.Stage;

/** Tells and asks a person something, in windows that nothing waits for: pictures go on being drawn. */
final class Dialogs {
    private final Stage owner;

    Dialogs(Stage owner) {
        this.owner = owner;
    }

    /** Says that something did not work. */
    void complain(String title, String message) {
        Alert alert = alert(AlertType.ERROR, title, message);
        alert.getDialogPane().setId("complaint");
        alert.show();
    }

    /** Asks what to do with changes that would be lost. */
    void askToSave(String name, Runnable save, Runnable discard) {
        ButtonType saving = new ButtonType("Save", ButtonData.YES);
        ButtonType discarding = new ButtonType("Don't save", ButtonData.NO);
        Alert alert = alert(
                AlertType.CONFIRMATION, "Save the changes to " + name + "?", "They are lost if you don't save them.");
        alert.getDialogPane().setId("save-question");
        alert.getButtonTypes().setAll(List.of(saving, discarding, ButtonType.CANCEL));
        alert.setOnHidden(_ -> {
            if (saving.equals(alert.getResult())) {
                save.run();
            } else if (discarding.equals(alert.getResult())) {
                discard.run();
            }
        });
        alert.show();
    }

    private Alert alert(AlertType type, String header, String message) {
        Alert alert = new Alert(type);
        alert.initOwner(owner);
        alert.setTitle("Twister");
        alert.setHeaderText(header);
        alert.setContentText(message);
        alert.setResizable(true);
        DialogPane pane = alert.getDialogPane();
        pane.getStylesheets().setAll(owner.getScene().getStylesheets());
        pane.setMinHeight(DialogPane.USE_PREF_SIZE);
        return alert;
    }
}
