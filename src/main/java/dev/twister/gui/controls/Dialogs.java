package dev.twister.gui.controls;

import dev.twister.mesh.MeshException;
import dev.twister.scene.SceneException;
import dev.twister.sky.SkyException;
import java.io.IOException;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import javafx.scene.control.Alert;
import javafx.scene.control.Alert.AlertType;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBar.ButtonData;
import javafx.scene.control.ButtonType;
import javafx.scene.control.DialogPane;
import javafx.stage.Stage;

/** Shows messages and questions in windows that do not block: drawing goes on. */
public final class Dialogs {
    private static final DateTimeFormatter TIME =
            DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm", Locale.ROOT).withZone(ZoneId.systemDefault());

    private final Stage owner;

    /** A button and its action. */
    public record Answer(String label, Runnable action) {
        static final Answer CANCEL = new Answer("Cancel", () -> {});
    }

    public Dialogs(Stage owner) {
        this.owner = owner;
    }

    /** Reports a failure. */
    public void complain(String title, String message) {
        Alert alert = alert(AlertType.ERROR, title, message);
        alert.getDialogPane().setId("complaint");
        alert.show();
    }

    /** Asks whether to save changes that would be lost; saving is the default. */
    public void askToSave(String name, Answer save, Answer discard) {
        ask(
                "save-question",
                "Save changes to " + name + "?",
                "Your changes will be lost if you don't save them.",
                save,
                discard,
                Answer.CANCEL);
    }

    /** Asks whether to overwrite a file that another program has changed. */
    public void askToOverwrite(String name, Answer other, Answer overwrite) {
        ask(
                "overwrite-question",
                name + " was changed by another program",
                "Overwriting it replaces those changes with yours.",
                other,
                overwrite,
                Answer.CANCEL);
    }

    /** Asks for another sky for a scene whose own cannot be read. */
    public void askForSky(String problem, Answer choose, Answer present) {
        ask("sky-question", "Couldn't load the scene's sky", problem, choose, present, Answer.CANCEL);
    }

    /** Asks whether to restore changes that were not saved before the program ended. */
    public void askToRestore(String name, Instant when, Answer restore, Answer discard, Answer later) {
        ask(
                "restore-question",
                "Restore unsaved changes to " + name + "?",
                "Twister ended before they were saved. They are from " + TIME.format(when) + ".",
                restore,
                discard,
                later);
    }

    /** Asks whether to replace frames of an earlier film. */
    public void askToReplaceFrames(String name, Answer other, Answer replace) {
        ask(
                "frames-question",
                name + " already exists",
                "Rendering replaces the frames of an earlier film.",
                other,
                replace,
                Answer.CANCEL);
    }

    /** Asks whether to cancel a render; continuing is the default. */
    public void askToCancelRender(String name, Answer cancel) {
        ButtonType yes = new ButtonType(cancel.label(), ButtonData.NO);
        ButtonType keep = new ButtonType("Keep rendering", ButtonData.CANCEL_CLOSE);
        Alert alert = alert(
                AlertType.CONFIRMATION,
                "Cancel the render?",
                name + " is not finished. It will be lost if you close the window now.");
        alert.getDialogPane().setId("render-question");
        alert.getButtonTypes().setAll(List.of(yes, keep));
        ((Button) alert.getDialogPane().lookupButton(keep)).setDefaultButton(true);
        alert.setOnHidden(_ -> {
            if (yes.equals(alert.getResult())) {
                cancel.action().run();
            }
        });
        alert.show();
    }

    private void ask(String id, String header, String message, Answer usual, Answer other, Answer neither) {
        ButtonType yes = new ButtonType(usual.label(), ButtonData.YES);
        ButtonType no = new ButtonType(other.label(), ButtonData.NO);
        Alert alert = alert(AlertType.CONFIRMATION, header, message);
        alert.getDialogPane().setId(id);
        alert.getButtonTypes().setAll(List.of(yes, no, new ButtonType(neither.label(), ButtonData.CANCEL_CLOSE)));
        alert.setOnHidden(_ -> {
            boolean isYes = yes.equals(alert.getResult());
            (isYes ? usual : no.equals(alert.getResult()) ? other : neither)
                    .action()
                    .run();
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

    /** The message of a failure that a user can cause; names anything else as a bug. */
    public static String explain(Throwable problem) {
        return switch (problem) {
            case SceneException _, SkyException _, MeshException _, IOException _ -> problem.getMessage();
            case OutOfMemoryError _ -> "There is not enough memory for it.";
            default -> "This is a bug of Twister's: " + problem;
        };
    }
}
