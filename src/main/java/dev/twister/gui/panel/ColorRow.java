package dev.twister.gui.panel;

import dev.twister.gui.controls.DropDownKeys;
import dev.twister.gui.property.ScreenColor;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.property.Row;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import javafx.collections.ListChangeListener;
import javafx.scene.Node;
import javafx.scene.control.ColorPicker;
import javafx.scene.layout.GridPane;
import javafx.scene.paint.Color;
import javafx.stage.Window;

/** A row for a color, shown as a picture at exposure 0 shows it. */
final class ColorRow extends PanelRow {
    private final ColorPicker picker = new ColorPicker();
    private final Function<Scene, Rgb> reader;
    private final BiFunction<Scene, Rgb, Scene> writer;
    private final Studio studio;
    private final String what;
    private boolean showing;

    private final ListChangeListener<Window> dialogs = change -> {
        while (change.next()) {
            change.getAddedSubList().forEach(ColorRow::hideOpacity);
        }
    };

    /**
     * A row that is empty until {@link #show}.
     *
     * @param reader reads the color of a scene, each channel in [0, 1]
     * @param writer returns the scene with another color
     */
    ColorRow(Row text, Studio studio, Function<Scene, Rgb> reader, BiFunction<Scene, Rgb, Scene> writer) {
        super(text.label(), text.hint(), text.keys());
        this.reader = reader;
        this.writer = writer;
        this.studio = studio;
        what = text.label().toLowerCase(Locale.ROOT);
        picker.valueProperty().subscribe((_, color) -> {
            if (!showing) {
                write(ScreenColor.linear(
                        new Rgb(color.getRed(), color.getGreen(), color.getBlue()), isSrgb(studio.scene())));
            }
        });
        // A drag in the open dialog of custom colors sets one value after the other.
        picker.showingProperty().subscribe(open -> {
            if (open) {
                Window.getWindows().addListener(dialogs);
            } else {
                Window.getWindows().removeListener(dialogs);
                studio.endGesture();
            }
        });
        DropDownKeys.install(picker);
        addControls(picker);
    }

    /** Shows the scene's color and enables a reset to the usual scene's. */
    void show(Scene scene, Scene usual) {
        Rgb rgb = reader.apply(scene);
        showing = true;
        Rgb seen = ScreenColor.shown(rgb, isSrgb(scene));
        Color color = new Color(seen.red(), seen.green(), seen.blue(), 1);
        if (!color.equals(picker.getValue())) {
            picker.setValue(color);
        }
        showing = false;
        Rgb usualColor = reader.apply(usual);
        setReset(!rgb.equals(usualColor), () -> write(usualColor));
    }

    @Override
    public Node firstControl() {
        return picker;
    }

    private static boolean isSrgb(Scene scene) {
        return scene.rendering().srgb();
    }

    /** Hides the opacity in the dialog of custom colors: no color here has one. */
    private static void hideOpacity(Window dialog) {
        Optional.ofNullable(dialog.getScene())
                .map(scene -> scene.getRoot().lookup("#settings-pane"))
                .filter(GridPane.class::isInstance)
                .map(GridPane.class::cast)
                .ifPresent(settings -> {
                    int last = settings.getRowCount() - 1;
                    for (Node node : settings.getChildren()) {
                        if (Objects.equals(GridPane.getRowIndex(node), last)) {
                            node.setVisible(false);
                            node.setManaged(false);
                        }
                    }
                });
    }

    private void write(Rgb rgb) {
        studio.edit(what, scene -> writer.apply(scene, rgb));
        if (!picker.isShowing()) {
            studio.endGesture();
        }
    }
}
