package dev.twister.gui.viewer;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.OwnedWindows;
import dev.twister.gui.files.FileChoice;
import dev.twister.gui.picture.ShownRadiance;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Studio;
import java.nio.file.Path;
import java.util.Optional;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.stage.Stage;

/** Windows with pictures of files. */
public final class PictureViewer {
    private static final double WIDTH = 1100;
    private static final double HEIGHT = 700;

    private final Stage owner;
    private final Studio studio;
    private final FileChoice choice;
    private final Dialogs dialogs;
    private final BackgroundTasks tasks;
    private Path folder = Path.of("").toAbsolutePath();

    public PictureViewer(Stage owner, Studio studio, FileChoice choice, Dialogs dialogs, BackgroundTasks tasks) {
        this.owner = owner;
        this.studio = studio;
        this.choice = choice;
        this.dialogs = dialogs;
        this.tasks = tasks;
    }

    /** Asks for a picture, and shows it in a window of its own. */
    public void open() {
        choice.picture(folder).ifPresent(file -> {
            folder = Optional.ofNullable(file.toAbsolutePath().getParent()).orElse(folder);
            tasks.run(
                    () -> ViewedPicture.read(file),
                    picture -> show(file, picture),
                    problem -> dialogs.complain("Couldn't open the picture", Dialogs.explain(problem)));
        });
    }

    private void show(Path file, ViewedPicture picture) {
        ViewerPane pane = new ViewerPane(
                picture, tasks, () -> studio.pictureProperty().get().map(shown -> ShownRadiance.of(studio, shown)));
        Scene scene = new Scene(pane, WIDTH, HEIGHT);
        scene.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.F) {
                pane.flip();
            }
        });
        String title =
                file.getFileName() + picture.part().map(part -> ", " + part).orElse("") + " – Twister";
        OwnedWindows.createHiddenByEscape(owner, title, scene).show();
    }
}
