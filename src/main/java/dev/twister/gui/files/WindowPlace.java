package dev.twister.gui.files;

import java.util.Optional;

/** Where a window is on the screen, and how large, in the screen's units. */
public record WindowPlace(double x, double y, double width, double height) {
    /** Of the panel's window; empty if it never was anywhere. */
    public static Optional<WindowPlace> of(WindowSettings settings) {
        int width = settings.get(WindowSettings.PANEL_WINDOW_WIDTH);
        int height = settings.get(WindowSettings.PANEL_WINDOW_HEIGHT);
        return Optional.of(new WindowPlace(
                        settings.get(WindowSettings.PANEL_X), settings.get(WindowSettings.PANEL_Y), width, height))
                .filter(_ -> width > 0 && height > 0);
    }

    /** The settings with this as the place of the panel's window. */
    public WindowSettings keptIn(WindowSettings settings) {
        return settings.with(WindowSettings.PANEL_X, clamped(x, -WindowSettings.MAX_SIDE))
                .with(WindowSettings.PANEL_Y, clamped(y, -WindowSettings.MAX_SIDE))
                .with(WindowSettings.PANEL_WINDOW_WIDTH, clamped(width, 0))
                .with(WindowSettings.PANEL_WINDOW_HEIGHT, clamped(height, 0));
    }

    private static int clamped(double number, int least) {
        return (int) Math.clamp(Math.rint(number), least, WindowSettings.MAX_SIDE);
    }
}
