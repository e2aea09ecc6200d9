package dev.twister.gui;

import dev.twister.engine.EngineOffer;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.files.AutosaveFolder;
import dev.twister.gui.files.SettingsStore;
import dev.twister.gui.files.ShippedFolders;
import dev.twister.gui.files.WindowSettings;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javafx.application.Platform;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.DialogPane;
import javafx.scene.control.Labeled;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyCombination.ModifierValue;
import javafx.scene.input.MouseButton;
import javafx.scene.paint.Color;
import javafx.scene.robot.Robot;
import javafx.stage.Stage;
import javafx.stage.Window;

/** The window on JavaFX's headless screen, with a hand on its keyboard and mouse. */
public final class WindowDriver implements AutoCloseable {
    public static final int WIDTH = 320;
    public static final int HEIGHT = 240;

    /** As large as the screen. */
    private static final double LARGE = 1000;

    /** Long enough for the slowest machine; only a failure takes it. */
    private static final long LIMIT_SECONDS = 300;

    /** The window is too small for the panel. */
    private static final SettingsStore.Found FOUND = new SettingsStore.Found(
            unfolded().with(WindowSettings.PANEL_SHOWN, false).withSize(WIDTH, HEIGHT), Optional.empty());

    private static WindowSettings unfolded() {
        WindowSettings settings = WindowSettings.DEFAULT;
        for (String heading : settings.get(WindowSettings.FOLDED)) {
            settings = settings.withFolded(heading, false);
        }
        return settings.with(WindowSettings.HINT_SEEN, true)
                .with(WindowSettings.DENOISED, false)
                .with(WindowSettings.FRAME_TIMES_SHOWN, true);
    }

    private static final AutosaveFolder NO_AUTOSAVES = new AutosaveFolder(Optional.empty());

    final Stage stage;
    public final Studio studio;
    public final MainWindow window;
    public final Answers files = new Answers();
    private final Robot robot;
    private volatile String notice = "";
    private final List<String> told = new CopyOnWriteArrayList<>();

    /** Started once for all tests of this JVM; it ends with it. */
    private static final class Toolkit {
        private static final CompletableFuture<Void> STARTED = new CompletableFuture<>();

        static {
            Platform.startup(() -> STARTED.complete(null));
            Platform.setImplicitExit(false);
        }
    }

    private WindowDriver(
            OpenedScene opened,
            EngineOffer engine,
            SettingsStore settings,
            SettingsStore.Found found,
            AutosaveFolder autosaves,
            double textScale) {
        stage = new Stage();
        stage.setX(0);
        stage.setY(0);
        studio = Studio.start(opened, engine, BlockEngine.offer());
        // Both cores would draw beside each test.
        studio.refiningProperty().set(false);
        window = new MainWindow(
                stage,
                studio,
                new MainWindow.Options(
                        files,
                        settings,
                        found,
                        autosaves,
                        new ShippedFolders(Path.of("scenes"), Path.of("skyboxes")),
                        Optional.of(Path.of("test.json")),
                        textScale,
                        // The heap of tests holds every window before this one, and takes long to collect.
                        new MainWindow.HeapMonitor(() -> 0, () -> {})));
        ((Labeled) stage.getScene().getRoot().lookup("#notice")).textProperty().subscribe(text -> {
            if (!text.isEmpty()) {
                notice = text;
                told.add(text);
            }
        });
        window.show();
        robot = new Robot();
    }

    /** A small window that shows its first picture. */
    public static WindowDriver open() {
        return open(WindowScenes.tiny(), BlockEngine.offer());
    }

    public static WindowDriver open(Scene scene, EngineOffer engine) {
        return open(scene, engine, TextScale.USUAL);
    }

    private static WindowDriver open(Scene scene, EngineOffer engine, double textScale) {
        return open(() -> new WindowDriver(
                untitled(scene), engine, new SettingsStore(Optional.empty()), FOUND, NO_AUTOSAVES, textScale));
    }

    /** A window with a scene that has a file, and with unsaved edits kept there. */
    public static WindowDriver open(OpenedScene opened, AutosaveFolder autosaves) {
        return open(opened, new SettingsStore(Optional.empty()), autosaves);
    }

    /** The same, whose settings will be kept there. */
    public static WindowDriver open(OpenedScene opened, SettingsStore settings, AutosaveFolder autosaves) {
        return open(() -> new WindowDriver(opened, BlockEngine.offer(), settings, FOUND, autosaves, TextScale.USUAL));
    }

    private static OpenedScene untitled(Scene scene) {
        return new OpenedScene(Path.of("test.json"), scene);
    }

    /** A window with the settings that are kept there. */
    public static WindowDriver open(SettingsStore settings) {
        return open(() -> new WindowDriver(
                untitled(WindowScenes.tiny()),
                BlockEngine.offer(),
                settings,
                settings.read(),
                NO_AUTOSAVES,
                TextScale.USUAL));
    }

    private static WindowDriver open(Callable<WindowDriver> opening) {
        Toolkit.STARTED.join();
        WindowDriver driver = call(opening);
        driver.await(() -> driver.studio
                .pictureProperty()
                .get()
                .filter(DrawnPicture::isWhole)
                .isPresent());
        return driver;
    }

    /** A window with room for the panel, which is shown; the focus is on the picture. */
    static WindowDriver openWithPanel() {
        return openWithPanel(TextScale.USUAL);
    }

    /** The same with text so much larger than usual. */
    static WindowDriver openWithPanel(double textScale) {
        WindowDriver driver = open(WindowScenes.tiny(), BlockEngine.offer(), textScale);
        driver.run(() -> {
            driver.stage.setWidth(LARGE);
            driver.stage.setHeight(LARGE);
        });
        driver.type(KeyCode.F9);
        driver.awaitCurrentPicture();
        return driver;
    }

    /** Does that on JavaFX's thread. */
    static <T> T call(Callable<T> action) {
        CompletableFuture<T> result = new CompletableFuture<>();
        Runnable task = () -> {
            try {
                result.complete(action.call());
            } catch (Exception | Error problem) {
                result.completeExceptionally(problem);
            }
        };
        if (Platform.isFxApplicationThread()) {
            task.run();
        } else {
            Platform.runLater(task);
        }
        try {
            return result.get(LIMIT_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException problem) {
            throw new AssertionError(problem);
        }
    }

    public void run(Runnable action) {
        call(() -> {
            action.run();
            return true;
        });
    }

    /** Lets pulses go by until that is so. */
    public void await(BooleanSupplier condition) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(LIMIT_SECONDS);
        while (!call(condition::getAsBoolean)) {
            if (System.nanoTime() > end) {
                throw new AssertionError("did not come to be; told were " + told + "; "
                        + call(() -> studio.drawingProperty().get().toString()));
            }
            pulse();
        }
    }

    /** Waits for a picture of that kind, and returns it. */
    DrawnPicture awaitPicture(Predicate<DrawnPicture> wanted) {
        await(() -> studio.pictureProperty().get().filter(wanted).isPresent());
        return call(() -> studio.pictureProperty().get().orElseThrow());
    }

    /**
     * Waits for a picture of what the studio holds now; one of the same scene before edits that were taken back is
     * none.
     */
    DrawnPicture awaitCurrentPicture() {
        long asked = call(studio::lastRequest);
        return awaitPicture(picture -> picture.isWhole() && picture.request().number() >= asked);
    }

    /** Waits until the picture is as fine as it gets and is on the screen. */
    DrawnPicture awaitRest() {
        run(() -> studio.refiningProperty().set(true));
        long asked = call(studio::lastRequest);
        DrawnPicture rest = awaitPicture(picture -> picture.isWhole()
                && picture.request().number() >= asked
                && picture.gathered().isDone());
        pulse();
        pulse();
        return rest;
    }

    /** Where the picture's view is on the screen. */
    Bounds pictureOnScreen() {
        return call(() -> {
            Node picture = stage.getScene().getRoot().lookup(".picture");
            return picture.localToScreen(picture.getLayoutBounds());
        });
    }

    /** The text of the label of that id. */
    public String text(String id) {
        return call(() -> ((Labeled) stage.getScene().getRoot().lookup("#" + id)).getText());
    }

    /** The window's dialog of that id, where it is shown. */
    Optional<DialogPane> dialog(String id) {
        return call(() -> Window.getWindows().stream()
                .map(window -> window.getScene().getRoot())
                .filter(root -> id.equals(root.getId()))
                .map(DialogPane.class::cast)
                .findFirst());
    }

    DialogPane awaitDialog(String id) {
        await(() -> dialog(id).isPresent());
        return dialog(id).orElseThrow();
    }

    /** Presses a button of a dialog, and waits until it is gone. */
    void answer(DialogPane dialog, String button) {
        run(() -> press(dialog, button));
        await(() -> dialog(dialog.getId()).filter(dialog::equals).isEmpty());
    }

    /** Presses the dialog's button of that name; on JavaFX's thread. */
    static void press(DialogPane dialog, String button) {
        dialog.getButtonTypes().stream()
                .filter(type -> type.getText().equals(button))
                .map(type -> (Button) dialog.lookupButton(type))
                .findFirst()
                .orElseThrow()
                .fire();
    }

    /** The last notice in the status line, which shows each for some seconds; here it stays. */
    public String notice() {
        return notice;
    }

    /** Waits until the status line has told that, whatever it has told since. */
    void awaitNotice(String text) {
        await(() -> told.contains(text));
    }

    /** Takes the last notice away. */
    void clearNotice() {
        run(() -> {
            studio.notice("");
            notice = "";
        });
    }

    /** Waits for a pulse to have gone by. */
    public void pulse() {
        CompletableFuture<Void> pulsed = new CompletableFuture<>();
        Runnable listener = () -> pulsed.complete(null);
        run(() -> stage.getScene().addPostLayoutPulseListener(listener));
        Platform.runLater(Platform::requestNextPulse);
        try {
            pulsed.get(LIMIT_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException problem) {
            throw new AssertionError(problem);
        }
        run(() -> stage.getScene().removePostLayoutPulseListener(listener));
    }

    void press(KeyCode... keys) {
        run(() -> List.of(keys).forEach(robot::keyPress));
        pulse();
    }

    void release(KeyCode... keys) {
        run(() -> List.of(keys).forEach(robot::keyRelease));
        pulse();
    }

    public void type(KeyCode key) {
        press(key);
        release(key);
    }

    /** A key while others are held. */
    void typeWith(KeyCode key, KeyCode... held) {
        run(() -> List.of(held).forEach(robot::keyPress));
        press(key);
        run(() -> robot.keyRelease(key));
        release(held);
    }

    /** The keys of a combination, such as those of a row of the panel. */
    public void type(KeyCombination combination) {
        KeyCodeCombination keys = (KeyCodeCombination) combination;
        List<KeyCode> held = new ArrayList<>();
        if (keys.getAlt() == ModifierValue.DOWN) {
            held.add(KeyCode.ALT);
        }
        if (keys.getShortcut() == ModifierValue.DOWN || keys.getControl() == ModifierValue.DOWN) {
            held.add(KeyCode.CONTROL);
        }
        if (keys.getShift() == ModifierValue.DOWN) {
            held.add(KeyCode.SHIFT);
        }
        typeWith(keys.getCode(), held.toArray(KeyCode[]::new));
    }

    /** What is in the window, of that kind; by a selector of style sheets. */
    public <T extends Node> T find(String selector, Class<T> kind) {
        return call(() -> kind.cast(stage.getScene().getRoot().lookup(selector)));
    }

    /** Clicks the middle of a node. */
    void click(Node node) {
        Point2D place = call(() -> node.localToScreen(
                node.getLayoutBounds().getCenterX(), node.getLayoutBounds().getCenterY()));
        click(place.getX(), place.getY());
    }

    /** Clicks a place on the screen. */
    void click(double x, double y) {
        withRobot(hand -> hand.mouseMove(x, y));
        withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));
        pulse();
    }

    /** The robot itself, for the mouse. */
    void withRobot(Consumer<Robot> action) {
        run(() -> action.accept(robot));
        pulse();
    }

    /** What is seen there on the screen. */
    Color pixel(double x, double y) {
        return call(() -> robot.getPixelColor(x, y));
    }

    @Override
    public void close() {
        run(() -> {
            stage.hide();
            window.close();
        });
        window.awaitFiles();
    }
}
