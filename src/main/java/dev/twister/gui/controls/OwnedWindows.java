package dev.twister.gui.controls;

import javafx.event.EventHandler;
import javafx.geometry.Rectangle2D;
import javafx.stage.Screen;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;

/** Where windows open that another one owns. */
public final class OwnedWindows {
    private OwnedWindows() {}

    /**
     * Centers a window over its owner when it is first shown, on the owner's screen: some window managers put it into
     * the screen's corner, with its title beyond the border.
     */
    public static void center(Stage stage, Stage owner) {
        stage.addEventHandler(WindowEvent.WINDOW_SHOWN, new EventHandler<>() {
            @Override
            public void handle(WindowEvent event) {
                stage.removeEventHandler(WindowEvent.WINDOW_SHOWN, this);
                Rectangle2D screen = Screen.getScreensForRectangle(
                                owner.getX(), owner.getY(), owner.getWidth(), owner.getHeight())
                        .stream()
                        .findFirst()
                        .orElseGet(Screen::getPrimary)
                        .getVisualBounds();
                stage.setX(between(
                        owner.getX() + (owner.getWidth() - stage.getWidth()) / 2,
                        screen.getMinX(),
                        screen.getMaxX() - stage.getWidth()));
                stage.setY(between(
                        owner.getY() + (owner.getHeight() - stage.getHeight()) / 2,
                        screen.getMinY(),
                        screen.getMaxY() - stage.getHeight()));
            }
        });
    }

    /** Not below the least, even where the most is. */
    private static double between(double wanted, double least, double most) {
        return Math.max(least, Math.min(wanted, most));
    }
}
