package dev.twister.gui.panel;

import dev.twister.gui.model.Radiance;
import dev.twister.gui.model.SceneNumbers;
import dev.twister.gui.model.SurroundingsNumbers;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Light;
import dev.twister.scene.Lights;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import java.util.List;
import java.util.stream.Stream;

/** The light. */
final class LightSection {
    private final Studio studio;
    private final List<NumberRow> numbers;
    private final ColorRow color;

    LightSection(Studio studio) {
        this.studio = studio;
        numbers = List.of(
                new NumberRow(SceneNumbers.LIGHT_X, "Alt+1", studio),
                new NumberRow(SceneNumbers.LIGHT_Y, "Alt+2", studio),
                new NumberRow(SceneNumbers.LIGHT_Z, "Alt+3", studio),
                new NumberRow(SceneNumbers.LIGHT_RADIUS, "Alt+L", studio),
                new NumberRow(SceneNumbers.LIGHT_STRENGTH, "Alt+Q", studio),
                new NumberRow(SurroundingsNumbers.AMBIENT, "Alt+Shift+L", studio));
        color = new ColorRow(
                "Light color",
                "The light's color. Set brightness with Light strength.",
                "Alt+C",
                studio,
                scene -> Radiance.of(scene.lights().first().color()).hue(),
                LightSection::withHue);
        studio.sceneProperty().subscribe(_ -> refresh());
        studio.document().originalProperty().subscribe(_ -> refresh());
    }

    List<PanelRow> rows() {
        return Stream.concat(numbers.stream(), Stream.of(color)).toList();
    }

    private static Scene withHue(Scene scene, Rgb hue) {
        Light light = scene.lights().first();
        Rgb radiance = Radiance.of(light.color()).withHueOf(hue).color();
        return scene.withLights(Lights.of(light.withColor(radiance)));
    }

    private void refresh() {
        numbers.forEach(row -> row.show(studio.scene(), studio.document().original()));
        color.show(studio.scene(), studio.document().original());
    }
}
