package dev.twister.gui.panel;

import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.property.LightNumbers;
import dev.twister.gui.property.LightNumbers.Radiance;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import java.util.List;
import java.util.stream.Stream;

/** The light that was selected last, else the first one. */
final class LightSection {
    private final Studio studio;
    private final List<NumberRow> numbers;
    private final ColorRow color;

    /** Its place in the scene's list. */
    private int shown;

    LightSection(Studio studio) {
        this.studio = studio;
        numbers = NumberRow.of(LightNumbers.of(() -> shown), studio);
        color = new ColorRow(
                "Light color",
                "The light's color. Set brightness with Light brightness.",
                "Alt+C",
                studio,
                scene -> Radiance.of(LightNumbers.light(scene, () -> shown).color())
                        .hue(),
                (scene, hue) -> LightNumbers.edited(scene, () -> shown, light -> withHue(light, hue)));
        studio.selection().activeProperty().subscribe(body -> select(body.intValue()));
        studio.sceneProperty().subscribe(_ -> refresh());
        studio.document().originalProperty().subscribe(_ -> refresh());
    }

    List<PanelRow> rows() {
        return Stream.concat(numbers.stream(), Stream.of(color)).toList();
    }

    private static Light withHue(Light light, Rgb hue) {
        return light.withColor(Radiance.of(light.color()).withHueOf(hue).color());
    }

    private void select(int body) {
        if (BodyEdits.isLight(studio.scene(), body) && BodyNumber.light(body) != shown) {
            // A field that loses the focus enters its text, now for another light.
            numbers.forEach(NumberRow::forgetTyped);
            shown = BodyNumber.light(body);
            refresh();
        }
    }

    private void refresh() {
        if (shown >= studio.scene().lights().count()) {
            shown = 0;
        }
        numbers.forEach(row -> row.show(studio.scene(), studio.document().original()));
        color.show(studio.scene(), studio.document().original());
    }
}
