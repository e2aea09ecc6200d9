package dev.twister.gui;

import javafx.animation.AnimationTimer;
import javafx.scene.Scene;
import javafx.scene.layout.BorderPane;
import javafx.stage.Stage;

/** The window: the picture in the middle, and around it what is said of it. */
final class MainWindow implements AutoCloseable {
    private static final double WIDTH = 1280;
    private static final double HEIGHT = 760;

    private final Stage stage;
    private final Studio studio;
    private final AnimationTimer timer;

    MainWindow(Stage stage, Studio studio) {
        this.stage = stage;
        this.studio = studio;
        PictureView picture = new PictureView(studio);
        StatusLine status = new StatusLine(studio);
        BorderPane root = new BorderPane(picture);
        root.setBottom(status);
        Scene scene = new Scene(root, WIDTH, HEIGHT);
        scene.getStylesheets().add(MainWindow.class.getResource("twister.css").toExternalForm());
        stage.setScene(scene);
        stage.setTitle("Twister");
        timer = new AnimationTimer() {
            @Override
            public void handle(long now) {
                picture.tellSize();
                studio.pulse();
            }
        };
    }

    void show() {
        stage.show();
        timer.start();
    }

    @Override
    public void close() {
        timer.stop();
        studio.close();
    }
}
