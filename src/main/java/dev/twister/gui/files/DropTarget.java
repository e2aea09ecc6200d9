package dev.twister.gui.files;

import java.io.File;
import javafx.scene.Scene;
import javafx.scene.input.DragEvent;
import javafx.scene.input.TransferMode;

/** Opens files that are dropped on the window. */
public final class DropTarget {
    private DropTarget() {}

    public static void install(Scene scene, FileActions files) {
        scene.setOnDragOver(event -> {
            if (event.getDragboard().hasFiles()) {
                event.acceptTransferModes(TransferMode.COPY);
            }
            event.consume();
        });
        scene.setOnDragDropped((DragEvent event) -> {
            boolean hasFiles = event.getDragboard().hasFiles();
            if (hasFiles) {
                files.drop(event.getDragboard().getFiles().stream()
                        .map(File::toPath)
                        .toList());
            }
            event.setDropCompleted(hasFiles);
            event.consume();
        });
    }
}
