package dev.twister.gui;

import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import java.util.Locale;
import java.util.function.BiFunction;
import java.util.function.Function;
import javafx.scene.Node;
import javafx.scene.control.ColorPicker;
import javafx.scene.paint.Color;

/** A colour, shown as the tone map "clamp" without the sRGB curve would: its linear channels are the screen's. */
final class ColorRow extends PanelRow {
    private final ColorPicker picker = new ColorPicker();
    private final Function<Scene, Rgb> reader;
    private final BiFunction<Scene, Rgb, Scene> writer;
    private final Studio studio;
    private final String what;
    private boolean showing;

    /**
     * A row that shows nothing until {@link #show}.
     *
     * @param reader the colour of a scene, each channel in [0, 1]
     * @param writer the scene with another colour
     */
    ColorRow(
            String label,
            String hint,
            String key,
            Studio studio,
            Function<Scene, Rgb> reader,
            BiFunction<Scene, Rgb, Scene> writer) {
        super(label, hint, key);
        this.reader = reader;
        this.writer = writer;
        this.studio = studio;
        what = label.toLowerCase(Locale.ROOT);
        picker.valueProperty().subscribe((_, color) -> {
            if (!showing) {
                write(new Rgb(color.getRed(), color.getGreen(), color.getBlue()));
            }
        });
        // While it is open, a drag in the dialog of custom colours sets one value after the other.
        picker.showingProperty().subscribe(open -> {
            if (!open) {
                studio.endGesture();
            }
        });
        DropDownKeys.install(picker);
        addControls(picker);
    }

    /** Shows the scene's colour; a reset leads to the usual scene's. */
    void show(Scene scene, Scene usual) {
        Rgb rgb = reader.apply(scene);
        showing = true;
        Color color =
                new Color(Math.clamp(rgb.red(), 0, 1), Math.clamp(rgb.green(), 0, 1), Math.clamp(rgb.blue(), 0, 1), 1);
        if (!color.equals(picker.getValue())) {
            picker.setValue(color);
        }
        showing = false;
        Rgb usualColor = reader.apply(usual);
        setReset(!rgb.equals(usualColor), () -> write(usualColor));
    }

    @Override
    Node firstControl() {
        return picker;
    }

    private void write(Rgb rgb) {
        studio.edit(what, scene -> writer.apply(scene, rgb));
        if (!picker.isShowing()) {
            studio.endGesture();
        }
    }
}
