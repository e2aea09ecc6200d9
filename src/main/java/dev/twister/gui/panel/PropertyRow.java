package dev.twister.gui.panel;

import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.property.DerivedNumbers.Radiance;
import dev.twister.gui.property.NumberProperty;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Integrator;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.ToneMap;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.PropertyType.Choice;
import dev.twister.scene.property.PropertyType.Color;
import dev.twister.scene.property.PropertyType.Flag;
import dev.twister.scene.property.PropertyType.LayerName;
import dev.twister.scene.property.Row;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.control.TextField;

/**
 * A row of the table of properties.
 *
 * @param follow shows a scene's value, and enables a reset to the usual scene's
 * @param only the integrator without which the property has no effect
 */
record PropertyRow(PanelRow row, BiConsumer<Scene, Scene> follow, Optional<Integrator> only) {
    /** The rows of properties of which none is a file; those without a label have none. */
    static List<PropertyRow> of(List<Property<Scene, ?>> properties, Studio studio) {
        return properties.stream()
                .filter(property -> !property.row().label().isEmpty())
                .flatMap(property -> of(property, studio))
                .toList();
    }

    /** The same, which show the scene, and lead back to the one that was opened. */
    static List<PanelRow> following(List<Property<Scene, ?>> properties, Studio studio) {
        return follow(of(properties, studio), studio);
    }

    static List<PanelRow> follow(List<PropertyRow> rows, Studio studio) {
        Runnable show = () ->
                rows.forEach(row -> row.show(studio.scene(), studio.document().original()));
        studio.sceneProperty().subscribe(_ -> show.run());
        studio.document().originalProperty().subscribe(_ -> show.run());
        return rows.stream().map(PropertyRow::row).toList();
    }

    @SuppressWarnings("unchecked") // a property's values are of its type
    static Stream<PropertyRow> of(Property<Scene, ?> property, Studio studio) {
        return switch (property.type()) {
            case Flag() -> Stream.of(flag((Property<Scene, Boolean>) property, studio));
            case Choice<?> choice -> Stream.of(choice((Property<Scene, Enum<?>>) property, choice.values(), studio));
            case LayerName() -> Stream.of(text((Property<Scene, String>) property, studio));
            case Color _ -> Stream.of(color((Property<Scene, Rgb>) property, studio));
            default -> PropertyNumbers.of(property).stream().map(number -> of(property, number, studio));
        };
    }

    /** The row of a number that stands for a property. */
    static PropertyRow of(Property<?, ?> property, NumberProperty<Scene> number, Studio studio) {
        NumberRow row = new NumberRow(number, studio);
        return new PropertyRow(row, row::show, property.row().only());
    }

    void show(Scene scene, Scene usual) {
        follow.accept(scene, usual);
        row.setIdle(only.filter(integrator -> integrator != scene.rendering().integrator())
                .map(integrator -> "No effect now: only with " + label(integrator) + "."));
    }

    void forgetTyped() {
        if (row instanceof NumberRow number) {
            number.forgetTyped();
        }
    }

    private static PropertyRow flag(Property<Scene, Boolean> property, Studio studio) {
        SwitchRow row = new SwitchRow(
                property.row().label(), property.row().hint(), property.row().keys(), on -> set(property, on, studio));
        return of(
                property,
                row,
                (scene, usual) -> row.show(
                        property.getter().apply(scene), property.getter().apply(usual)));
    }

    private static PropertyRow choice(
            Property<Scene, Enum<?>> property, List<? extends Enum<?>> values, Studio studio) {
        ChoiceRow<Enum<?>> row = new ChoiceRow<>(
                property.row().label(),
                property.row().hint(),
                property.row().keys(),
                value -> new Look(label(value)),
                value -> set(property, value, studio),
                studio::notice);
        return of(
                property,
                row,
                (scene, usual) -> row.show(
                        List.copyOf(values),
                        property.getter().apply(scene),
                        property.getter().apply(usual)));
    }

    private static PropertyRow text(Property<Scene, String> property, Studio studio) {
        NameRow row = new NameRow(property.row(), text -> set(property, text, studio), studio::notice);
        return of(
                property,
                row,
                (scene, usual) -> row.show(
                        property.getter().apply(scene), property.getter().apply(usual)));
    }

    /** What is brighter than a screen can show keeps its brightness when its color is chosen. */
    private static PropertyRow color(Property<Scene, Rgb> property, Studio studio) {
        ColorRow row = new ColorRow(
                property.row(),
                studio,
                scene -> shown(property.getter().apply(scene)),
                (scene, rgb) -> property.wither()
                        .apply(scene, brightAs(property.getter().apply(scene), rgb)));
        return of(property, row, row::show);
    }

    private static Rgb shown(Rgb color) {
        Radiance radiance = Radiance.of(color);
        return radiance.strength() > 1 ? radiance.hue() : color;
    }

    private static Rgb brightAs(Rgb old, Rgb chosen) {
        double factor = Math.max(1, Radiance.of(old).strength());
        return new Rgb(factor * chosen.red(), factor * chosen.green(), factor * chosen.blue());
    }

    private static PropertyRow of(Property<?, ?> property, PanelRow row, BiConsumer<Scene, Scene> follow) {
        return new PropertyRow(row, follow, property.row().only());
    }

    private static <V> void set(Property<Scene, V> property, V value, Studio studio) {
        studio.editOnce(
                property.row().label().toLowerCase(Locale.ROOT),
                scene -> property.wither().apply(scene, value));
    }

    private static String label(Object value) {
        return switch (value) {
            case Integrator.WHITTED -> "Real time";
            case Integrator.PATH -> "Path tracing";
            case ToneMap.ACES -> "ACES";
            default -> {
                String name = value.toString();
                yield name.charAt(0) + name.substring(1).toLowerCase(Locale.ROOT);
            }
        };
    }

    /** A row for the name of a layer. */
    private static final class NameRow extends PanelRow {
        private final TextField field = new TextField();
        private final Consumer<String> choose;
        private final Consumer<String> complain;
        private String shown = "";

        /**
         * A row that is empty until {@link #show}.
         *
         * @param choose called when a person has entered another, allowed name
         * @param complain called with a message about any other text
         */
        NameRow(Row row, Consumer<String> choose, Consumer<String> complain) {
            super(row.label(), row.hint(), "");
            this.choose = choose;
            this.complain = complain;
            field.setOnAction(_ -> take());
            field.focusedProperty().subscribe(focused -> {
                if (!focused) {
                    take();
                }
            });
            addControls(field);
        }

        /** Shows what is, and what a reset would lead to. */
        void show(String text, String usual) {
            if (!text.equals(shown) || !field.isFocused()) {
                shown = text;
                field.setText(text);
            }
            setReset(!text.equals(usual), () -> choose.accept(usual));
        }

        @Override
        public Node firstControl() {
            return field;
        }

        private void take() {
            String typed = field.getText().strip();
            if (typed.equals(shown)) {
                return;
            }
            if (LightGroup.isName(typed)) {
                shown = typed;
                choose.accept(typed);
            } else {
                complain.accept(name() + " is '" + typed + "', but must be at most " + LightGroup.MAX_NAME_LENGTH
                        + " letters, digits, hyphens and underscores");
                field.setText(shown);
            }
        }
    }
}
