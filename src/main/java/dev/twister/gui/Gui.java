package dev.twister.gui;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.logging.Logger;
import javafx.application.Platform;
import javafx.stage.Stage;

/** Starts the window. */
public final class Gui {
    /** JavaFX says at each start that it would rather be on the module path; TornadoVM's SDK has that to itself. */
    private static final String CLASS_PATH_NOTICE = "Unsupported JavaFX configuration";

    private Gui() {}

    /**
     * Shows the window and returns when it has been closed.
     *
     * @throws NoDisplayException where there is no screen
     */
    public static void run(GuiOptions options) {
        Display.check();
        // The readers of PNG and JPEG skies are AWT's, which must not open a display of its own beside JavaFX's.
        System.setProperty("java.awt.headless", "true");
        Logger logger = Logger.getLogger("javafx");
        logger.setFilter(record -> !String.valueOf(record.getMessage()).startsWith(CLASS_PATH_NOTICE));
        CompletableFuture<Optional<Throwable>> end = new CompletableFuture<>();
        try {
            Platform.startup(() -> open(options, end));
        } catch (RuntimeException | LinkageError problem) {
            throw new NoDisplayException(Display.explain(problem), problem);
        }
        Optional<Throwable> failure = end.join();
        Platform.exit();
        failure.ifPresent(problem -> {
            throw new CompletionException(problem);
        });
    }

    private static void open(GuiOptions options, CompletableFuture<Optional<Throwable>> end) {
        try {
            Stage stage = new Stage();
            Studio studio = Studio.start(options);
            MainWindow window = new MainWindow(stage, studio);
            stage.setOnHidden(_ -> {
                window.close();
                end.complete(Optional.empty());
            });
            window.show();
        } catch (RuntimeException | LinkageError problem) {
            end.complete(Optional.of(problem));
        }
    }
}
