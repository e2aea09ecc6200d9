package dev.twister.gui;

import dev.twister.bench.report.WindowRates;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.files.AutosaveFolder;
import dev.twister.gui.files.DroppedFile;
import dev.twister.gui.files.SettingsStore;
import dev.twister.gui.files.ShippedFolders;
import dev.twister.gui.files.SystemFileChoice;
import dev.twister.gui.files.WindowSettings;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.gui.studio.Studio;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.logging.Logger;
import javafx.application.Platform;
import javafx.stage.Stage;

/** Starts the window. */
public final class Gui {
    /** JavaFX says at each start that it would rather be on the module path; TornadoVM's SDK has that to itself. */
    private static final String CLASS_PATH_NOTICE = "Unsupported JavaFX configuration";

    private static final String TOOLKIT = "glass.platform";

    private Gui() {}

    /**
     * Shows the window and returns when it has been closed.
     *
     * @param engine the id of the first engine; empty for the one last chosen in the window
     * @param shipped the scenes that are offered and never overwritten
     * @throws NoDisplayException if there is no screen
     */
    public static void run(FirstScene first, Optional<String> engine, ShippedFolders shipped) {
        start(first, engine, shipped, UserFiles.ofThisUser(), _ -> {});
    }

    /**
     * Shows the window while its camera moves around the scene, and returns how fast it was; the user's settings have
     * no effect and are not changed.
     *
     * @param engine the id of the engine; empty for {@code auto}
     * @param shipped the scenes that are offered
     * @return empty if the window was closed early, the engine did not start in time, or fewer than two pictures were
     *     shown
     * @throws NoDisplayException if there is no screen
     */
    public static Optional<WindowRates> measure(FirstScene first, Optional<String> engine, ShippedFolders shipped) {
        AtomicReference<Optional<WindowRates>> measured = new AtomicReference<>(Optional.empty());
        start(first, engine, shipped, UserFiles.NONE, window -> window.measure(measured::set));
        return measured.get();
    }

    private static void start(
            FirstScene first,
            Optional<String> engine,
            ShippedFolders shipped,
            UserFiles own,
            Consumer<MainWindow> whenOpen) {
        checkDisplay();
        chooseLanguage();
        // PNG and JPEG skies are read by AWT, which must not open a display besides JavaFX's.
        System.setProperty("java.awt.headless", "true");
        Logger logger = Logger.getLogger("javafx");
        logger.setFilter(record -> !String.valueOf(record.getMessage()).startsWith(CLASS_PATH_NOTICE));
        double textScale = TextScale.ofSystem();
        SettingsStore.Found found = own.settings().read();
        CompletableFuture<Runnable> end = new CompletableFuture<>();
        try {
            Platform.startup(() -> {
                try {
                    whenOpen.accept(open(first, engine, shipped, own, found, textScale, end));
                } catch (RuntimeException | LinkageError problem) {
                    end.completeExceptionally(problem);
                }
            });
        } catch (RuntimeException | LinkageError problem) {
            throw new NoDisplayException(explain(problem), problem);
        }
        try {
            // The window is hidden while the last files are written.
            end.join().run();
        } finally {
            Platform.exit();
        }
    }

    /** Whether that is a panorama's file that is there, by its name and its first bytes. */
    public static boolean isPanorama(Path file) {
        return Files.isRegularFile(file) && DroppedFile.kind(file) == DroppedFile.Kind.SKYBOX;
    }

    private static MainWindow open(
            FirstScene first,
            Optional<String> engine,
            ShippedFolders shipped,
            UserFiles own,
            SettingsStore.Found found,
            double textScale,
            CompletableFuture<Runnable> end) {
        Stage stage = new Stage();
        String id = engine.orElse(found.settings().get(WindowSettings.ENGINE));
        // Looking for engines takes TornadoVM a second: that is left to the thread that opens this one.
        EngineOffer offer = EngineOffer.working(id, "", "", () -> Engines.open(id));
        Studio studio = Studio.start(first.opened(), offer, JvmEngines.parallel());
        MainWindow window = new MainWindow(
                stage,
                studio,
                new MainWindow.Options(
                        new SystemFileChoice(stage),
                        own.settings(),
                        found,
                        own.autosaves(),
                        shipped,
                        Optional.of(first.opened().file().path()).filter(_ -> first.asked()),
                        textScale,
                        new MainWindow.HeapMonitor()));
        stage.setOnHidden(_ -> {
            window.close();
            end.complete(window::awaitFiles);
        });
        window.show();
        first.toOpen().ifPresent(window.workbench().files()::open);
        return window;
    }

    /** What the window keeps between runs. */
    private record UserFiles(SettingsStore settings, AutosaveFolder autosaves) {
        /** The defaults; nothing is kept. */
        static final UserFiles NONE =
                new UserFiles(new SettingsStore(Optional.empty()), new AutosaveFolder(Optional.empty()));

        static UserFiles ofThisUser() {
            return new UserFiles(SettingsStore.ofThisUser(), AutosaveFolder.ofThisUser());
        }
    }

    /**
     * Looks before JavaFX does, which would end with a stack trace on its own thread.
     *
     * @throws NoDisplayException if there is certainly no screen
     */
    static void checkDisplay() {
        boolean unix =
                !System.getProperty("os.name", "").toLowerCase(Locale.ROOT).matches("(windows|mac).*");
        if (unix && System.getProperty(TOOLKIT) == null && isEmpty(System.getenv("DISPLAY"))) {
            throw new NoDisplayException("DISPLAY is not set", null);
        }
    }

    private static boolean isEmpty(String value) {
        return value == null || value.isEmpty();
    }

    /** What kept JavaFX from starting, in a few words. */
    static String explain(Throwable problem) {
        Throwable cause = problem;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        return String.valueOf(cause.getMessage()).lines().findFirst().orElse("JavaFX did not start");
    }

    /** Called before JavaFX starts, which has texts in several languages and takes the system's. */
    static void chooseLanguage() {
        Locale.setDefault(Locale.ENGLISH);
    }

    /**
     * What the window starts with.
     *
     * @param opened shown first
     * @param asked whether the user named it, so that it is listed among recent scenes
     * @param toOpen a file that could not be read before: the window opens it and tells what is wrong with it
     */
    public record FirstScene(OpenedScene opened, boolean asked, Optional<Path> toOpen) {
        /** A scene that nobody named. */
        public static FirstScene of(OpenedScene opened) {
            return new FirstScene(opened, false, Optional.empty());
        }
    }

    /** There is no screen to open a window on; the message says so, and what can be done without one. */
    public static final class NoDisplayException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        NoDisplayException(String why, Throwable cause) {
            super(
                    "no window can be opened: " + why
                            + "; 'twister render SCENE -o FILE' and 'twister benchmark' need no display",
                    cause);
        }
    }
}
