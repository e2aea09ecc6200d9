package dev.twister.gui;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javafx.scene.text.Font;

/**
 * The user's text scale. JavaFX follows the screen's pixel density and the text size of Windows by itself, but not the
 * text scaling factor of GNOME.
 */
final class TextScale {
    static final double USUAL = 1;

    private static final double SMALLEST = 0.5;
    private static final double LARGEST = 4;
    private static final List<String> QUESTION =
            List.of("gsettings", "get", "org.gnome.desktop.interface", "text-scaling-factor");
    private static final long PATIENCE_MILLIS = 500;

    private TextScale() {}

    /** This system's factor; {@link #USUAL} if it has none. */
    static double ofSystem() {
        return isGnomePossible() ? ask().flatMap(TextScale::parse).orElse(USUAL) : USUAL;
    }

    /** A factor that makes sense, as it was printed. */
    static Optional<Double> parse(String printed) {
        try {
            return Optional.of(Double.parseDouble(printed.strip()))
                    .filter(factor -> factor >= SMALLEST && factor <= LARGEST);
        } catch (NumberFormatException _) {
            return Optional.empty();
        }
    }

    /** The address of a style sheet that scales all text, and with it all that is measured in its height. */
    static String styleSheet(double factor) {
        // What pops up does not inherit from the window.
        String rule = String.format(
                Locale.ROOT,
                ".root, .tooltip, .context-menu, .combo-box-popup { -fx-font-size: %.2fpx; }",
                factor * Font.getDefault().getSize());
        return "data:text/css;base64," + Base64.getEncoder().encodeToString(rule.getBytes(StandardCharsets.UTF_8));
    }

    private static boolean isGnomePossible() {
        return System.getProperty("os.name", "").toLowerCase(Locale.ROOT).contains("linux");
    }

    private static Optional<String> ask() {
        try {
            Process process = new ProcessBuilder(QUESTION)
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
            if (!process.waitFor(PATIENCE_MILLIS, TimeUnit.MILLISECONDS)) {
                process.destroyForcibly();
                return Optional.empty();
            }
            return Optional.of(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException _) {
            // There is no such program here.
            return Optional.empty();
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
            return Optional.empty();
        }
    }
}
