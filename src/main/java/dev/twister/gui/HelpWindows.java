package dev.twister.gui;

import dev.twister.files.TwisterVersion;
import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.OwnedWindows;
import dev.twister.gui.panel.PanelRow;
import dev.twister.gui.panel.PanelSection;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.geometry.Rectangle2D;
import javafx.scene.Scene;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.stage.Screen;
import javafx.stage.Stage;

/** The windows that explain: which key does what, and what this program is. One of each at a time. */
final class HelpWindows {
    private static final double MOST_OF_THE_SCREEN = 0.9;

    private static final List<KeyLine> CAMERA = List.of(
            new KeyLine("W A S D", "Walk; with Shift, run"),
            new KeyLine("E Q", "Up and down"),
            new KeyLine("Middle drag", "Turn about the selected bodies, or what is in the middle; with Shift, pan"),
            new KeyLine("Alt+wheel, Shift+wheel", "Nearer or farther"),
            new KeyLine("Drag, ← → ↑ ↓", "Look around; with Shift, the arrows turn faster"),
            new KeyLine("Wheel", "Field of view"),
            new KeyLine("Ctrl+Shift+click", "Focus on what is under the pointer"),
            new KeyLine("Alt+click", "Path of the pixel: its rays as lines, and a table of its steps"),
            new KeyLine("Ctrl+wheel, Ctrl+drag", "Magnify the picture, move what is magnified"),
            new KeyLine("Home", "Back to where the scene has the camera"),
            new KeyLine("Ctrl+0 … Ctrl+9", "Keep the camera as a view of the scene"),
            new KeyLine("0 … 9", "Go to the scene's view of that number"));
    private static final List<KeyLine> BODIES = List.of(
            new KeyLine("Click", "Select a sphere, a mesh, the light or the plane"),
            new KeyLine("Shift+click, Ctrl+click", "Add it to the selection, or take it out"),
            new KeyLine("Drag a selected one", "Move all selected ones, at the same distance from the camera"),
            new KeyLine("Drag an arrow", "Move them along its axis"),
            new KeyLine("X, Y, Z while dragging", "Move along that axis, or freely again"),
            new KeyLine("Ctrl while dragging", "Snap the one that is held to half meters"),
            new KeyLine("Drop a file", "Open a scene or a mesh; a panorama becomes the sky"));

    /** What a key or a movement of the mouse does. */
    private record KeyLine(String keys, String meaning) {}

    private final Stage owner;
    private Optional<Stage> controls = Optional.empty();
    private Optional<Stage> about = Optional.empty();

    HelpWindows(Stage owner) {
        this.owner = owner;
    }

    /**
     * Shows which key does what.
     *
     * @param rows the panel's
     */
    void showControls(List<PanelRow> rows) {
        Stage stage = controls.orElseGet(() -> window("Controls"));
        // Which rows there are depends on what is selected.
        show(stage, scrolling(controlsPage(rows)));
        controls = Optional.of(stage);
    }

    void showAbout() {
        Stage stage = about.orElseGet(() -> window("About Twister"));
        show(stage, aboutPage());
        about = Optional.of(stage);
    }

    private static void show(Stage stage, Region page) {
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        page.setMaxSize(MOST_OF_THE_SCREEN * screen.getWidth(), MOST_OF_THE_SCREEN * screen.getHeight());
        stage.getScene().setRoot(page);
        // With the focus it scrolls by the keyboard.
        page.requestFocus();
        stage.show();
        stage.toFront();
    }

    void close() {
        controls.ifPresent(Stage::close);
        about.ifPresent(Stage::close);
    }

    private Stage window(String title) {
        return OwnedWindows.createHiddenByEscape(owner, title, new Scene(new Region()));
    }

    private static Region scrolling(Region page) {
        ScrollPane scroll = new ScrollPane(page);
        scroll.setFitToWidth(true);
        scroll.getStyleClass().add("help");
        return scroll;
    }

    private static Region controlsPage(List<PanelRow> rows) {
        VBox page = page("controls-page");
        page.getChildren().add(table("Camera", CAMERA));
        page.getChildren().add(table("Bodies", BODIES));
        for (Command.Group group : Command.Group.values()) {
            List<KeyLine> lines = new ArrayList<>();
            for (Command command : Command.values()) {
                if (command.group() == group) {
                    lines.add(new KeyLine(command.keys().getDisplayText(), command.label() + ": " + command.hint()));
                }
            }
            page.getChildren().add(table(group.label(), lines));
        }
        page.getChildren()
                .add(table(
                        "Panel: go to a control, then use the arrow keys",
                        rows.stream()
                                .filter(row -> !row.keys().getDisplayText().isEmpty())
                                .map(row -> new KeyLine(row.keys().getDisplayText(), row.name()))
                                .toList()));
        return page;
    }

    private static Region aboutPage() {
        VBox page = page("about-page");
        Label title = new Label("Twister " + TwisterVersion.text());
        title.getStyleClass().add("title");
        page.getChildren().add(title);
        for (String paragraph : List.of(
                "A real-time ray tracer written entirely in Java. One small kernel in plain Java draws the picture on"
                        + " one thread, on all threads, and, through TornadoVM, on OpenCL, CUDA and Metal devices; the"
                        + " same equations in packets draw it on the processor's SIMD lanes.",
                "It follows \u201cAccelerating Java Ray Tracing Applications on Heterogeneous Hardware\u201d by Pham Van,"
                        + " Fumero, Stratikopoulos, Blanaru and Kotselidis.",
                "Licensed under the Apache License 2.0.",
                "Java " + Runtime.version() + ", JavaFX " + System.getProperty("javafx.runtime.version", "") + ", "
                        + System.getProperty("os.name") + " " + System.getProperty("os.arch") + ".")) {
            Label label = new Label(paragraph);
            label.setWrapText(true);
            page.getChildren().add(label);
        }
        return page;
    }

    private static VBox page(String id) {
        VBox page = new VBox();
        page.setId(id);
        page.getStyleClass().add("page");
        return page;
    }

    private static Region table(String heading, List<KeyLine> lines) {
        GridPane grid = new GridPane();
        grid.getStyleClass().add("keys");
        for (int line = 0; line < lines.size(); line++) {
            Label keys = new Label(lines.get(line).keys());
            keys.getStyleClass().add("key");
            keys.setMinWidth(Region.USE_PREF_SIZE);
            Label meaning = new Label(lines.get(line).meaning());
            meaning.setWrapText(true);
            grid.addRow(line, keys, meaning);
        }
        return new PanelSection(heading, grid);
    }
}
