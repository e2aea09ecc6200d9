package dev.twister.gui.controls;

import javafx.event.EventHandler;
import javafx.geometry.Rectangle2D;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.stage.Screen;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;

/** Windows that another one owns. */
public final class OwnedWindows {
    private OwnedWindows() {}

    /**
     * A window that is not shown yet, and looks like its owner. It is centered over its owner when it is first shown,
     * on the owner's screen: some window managers put it into the screen's corner, with its title beyond the border.
     */
    public static Stage create(Stage owner, String title, Scene scene) {
        Stage stage = new Stage();
        stage.initOwner(owner);
        stage.setTitle(title);
        scene.getStylesheets().setAll(owner.getScene().getStylesheets());
        stage.setScene(scene);
        // Before it is shown: a window manager may move it back later.
        stage.addEventHandler(WindowEvent.WINDOW_SHOWING, new EventHandler<>() {
            @Override
            public void handle(WindowEvent event) {
                stage.removeEventHandler(WindowEvent.WINDOW_SHOWING, this);
                place(stage, owner);
            }
        });
        return stage;
    }

    /** The same, which Escape hides. */
    public static Stage createHiddenByEscape(Stage owner, String title, Scene scene) {
        Stage stage = create(owner, title, scene);
        scene.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                stage.hide();
            }
        });
        return stage;
    }

    private static void place(Stage stage, Stage owner) {
        Scene scene = stage.getScene();
        scene.getRoot().applyCss();
        double width = scene.getWidth() > 0 ? scene.getWidth() : scene.getRoot().prefWidth(-1);
        double height =
                scene.getHeight() > 0 ? scene.getHeight() : scene.getRoot().prefHeight(width);
        Rectangle2D screen =
                Screen.getScreensForRectangle(owner.getX(), owner.getY(), owner.getWidth(), owner.getHeight()).stream()
                        .findFirst()
                        .orElseGet(Screen::getPrimary)
                        .getVisualBounds();
        stage.setX(between(owner.getX() + (owner.getWidth() - width) / 2, screen.getMinX(), screen.getMaxX() - width));
        stage.setY(
                between(owner.getY() + (owner.getHeight() - height) / 2, screen.getMinY(), screen.getMaxY() - height));
    }

    /** Not below the least, even where the most is. */
    private static double between(double wanted, double least, double most) {
        return Math.max(least, Math.min(wanted, most));
    }
}
