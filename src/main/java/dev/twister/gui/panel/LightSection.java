package dev.twister.gui.panel;

import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.property.DerivedNumbers;
import dev.twister.gui.property.DerivedNumbers.Radiance;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneProperties;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The light that was selected last, else the first one. */
final class LightSection {
    private final Studio studio;
    private final List<PropertyRow> rows;

    /** The rows of each of a light's properties, by its name. */
    private final Map<String, List<PropertyRow>> ofLight;

    /** Its place in the scene's list. */
    private int shown;

    LightSection(Studio studio) {
        this.studio = studio;
        ofLight = LightProperties.ALL.stream()
                .filter(property -> !property.row().label().isEmpty())
                .collect(Collectors.toMap(
                        Property::name, property -> rows(property).toList(), (one, _) -> one, LinkedHashMap::new));
        rows = Stream.concat(
                        ofLight.values().stream().flatMap(List::stream),
                        PropertyRow.of(
                                Property.within(SceneProperties.SHADING, Scene::shading, Scene::withShading), studio)
                                .stream())
                .toList();
        studio.selection().activeProperty().subscribe(body -> select(body.intValue()));
        studio.sceneProperty().subscribe(_ -> refresh());
        studio.document().originalProperty().subscribe(_ -> refresh());
    }

    List<PanelRow> rows() {
        return rows.stream().map(PropertyRow::row).toList();
    }

    /** A color has two rows, its hue and its brightness. */
    private Stream<PropertyRow> rows(Property<Light, ?> property) {
        Stream<PropertyRow> numbers =
                PropertyNumbers.ofLight(property, () -> shown).map(number -> PropertyRow.of(property, number, studio));
        if (property.equals(LightProperties.COLOR)) {
            ColorRow color = new ColorRow(
                    property.row(),
                    studio,
                    scene -> Radiance.of(
                                    DerivedNumbers.light(scene, () -> shown).color())
                            .hue(),
                    (scene, hue) -> DerivedNumbers.edited(scene, () -> shown, light -> withHue(light, hue)));
            return Stream.concat(numbers, Stream.of(new PropertyRow(color, color::show, Optional.empty())));
        }
        return property.count() > 0
                ? numbers
                : PropertyRow.of(
                        property.in(
                                scene -> DerivedNumbers.light(scene, () -> shown),
                                (scene, edit) -> DerivedNumbers.edited(scene, () -> shown, edit)),
                        studio);
    }

    private static Light withHue(Light light, Rgb hue) {
        return light.withColor(Radiance.of(light.color()).withHueOf(hue).color());
    }

    private void select(int body) {
        if (BodyEdits.isLight(studio.scene(), body) && BodyNumber.light(body) != shown) {
            // A field that loses the focus enters its text, now for another light.
            rows.forEach(PropertyRow::forgetTyped);
            shown = BodyNumber.light(body);
            refresh();
        }
    }

    private void refresh() {
        if (shown >= studio.scene().lights().count()) {
            shown = 0;
        }
        rows.forEach(row -> row.show(studio.scene(), studio.document().original()));
        LightShape.Kind kind = studio.scene().lights().get(shown).shape().kind();
        ofLight.forEach((property, ofProperty) -> ofProperty.forEach(row -> {
            row.row().setVisible(LightProperties.has(kind, property));
            row.row().setManaged(row.row().isVisible());
        }));
    }
}
