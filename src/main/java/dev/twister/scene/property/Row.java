package dev.twister.scene.property;

import dev.twister.scene.Integrator;
import java.util.Optional;

/**
 * How the window shows a property.
 *
 * @param label such as "Shadow samples"; of three numbers, the label of each begins with it
 * @param hint one sentence for the tooltip
 * @param keys that lead to its row, such as "Alt+S", or to its three rows, with spaces between; may be empty
 * @param only the integrator without which it has no effect
 */
public record Row(String label, String hint, String keys, Slide slide, Optional<Integrator> only) {
    public static final Row NONE = new Row("", "", "", Slide.SHARE, Optional.empty());
}
