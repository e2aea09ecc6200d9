package dev.twister.gui.rendering;

import dev.twister.gui.controls.NumberField;
import dev.twister.gui.controls.PlainBox;
import dev.twister.image.PictureSize;
import dev.twister.scene.property.SceneProperties;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;

/** The fields of a picture's size: a usual size, or two numbers. */
final class SizeFields extends HBox {
    private static final List<PictureSize> USUAL = List.of(PictureSize.HD, PictureSize.FULL_HD, PictureSize.ULTRA_HD);

    private final PlainBox<Preset> preset;
    private final NumberField width;
    private final NumberField height;
    private final Runnable changed;
    private boolean showing;

    /** An item of the list: a usual size, that of the window's picture, or, without a size, a custom one. */
    private record Preset(String label, Optional<PictureSize> size) {
        static final Preset CUSTOM = new Preset("Custom", Optional.empty());

        static Preset of(String label, PictureSize size) {
            return new Preset(label + size.width() + " × " + size.height(), Optional.of(size));
        }
    }

    /** @param changed called when the size changes */
    SizeFields(Runnable changed) {
        this.changed = changed;
        preset = new PlainBox<>("render-size", Preset::label, this::takePreset);
        width = new NumberField("Width", SceneProperties.WIDTH.range(), true, this::takeNumbers);
        height = new NumberField("Height", SceneProperties.WIDTH.range(), true, this::takeNumbers);
        getStyleClass().add("render-fields");
        setHgrow(preset, Priority.ALWAYS);
        getChildren().addAll(preset, width, new Label("×"), height);
    }

    void show(PictureSize size) {
        showing = true;
        width.show(size.width());
        height.show(size.height());
        showing = false;
        showPreset();
        changed.run();
    }

    /** Offers the usual sizes and that of the window's picture. */
    void offer(Optional<PictureSize> window) {
        preset.offer(
                Stream.of(
                                USUAL.stream().map(size -> Preset.of("", size)),
                                window.stream().map(size -> Preset.of("Window: ", size)),
                                Stream.of(Preset.CUSTOM))
                        .flatMap(presets -> presets)
                        .toList(),
                Optional.of(Preset.CUSTOM));
        showPreset();
    }

    /** The size; empty if {@link #complaint} tells why there is none. */
    Optional<PictureSize> size() {
        return complaint().isPresent()
                ? Optional.empty()
                : Optional.of(new PictureSize(width.wholeNumber(), height.wholeNumber()));
    }

    /** The error message; empty if the size is allowed. */
    Optional<String> complaint() {
        return width.complaint().or(height::complaint);
    }

    /** The control that the row's mnemonic leads to. */
    PlainBox<?> firstControl() {
        return preset;
    }

    private void takePreset() {
        preset.choice().flatMap(Preset::size).ifPresent(this::show);
    }

    private void takeNumbers() {
        if (!showing) {
            showPreset();
            changed.run();
        }
    }

    private void showPreset() {
        Optional<PictureSize> size = size();
        preset.getItems().stream()
                .filter(offered -> offered.size().isPresent() && offered.size().equals(size))
                .findFirst()
                .or(() -> Optional.of(Preset.CUSTOM))
                .ifPresent(preset::show);
    }
}
