package dev.twister.gui.picture;

import dev.twister.explain.PathStep;
import dev.twister.explain.PathStep.FoundLight;
import dev.twister.explain.PathStep.LightPart;
import dev.twister.explain.PathStep.Scattering;
import dev.twister.explain.PathStep.ShadedSurface;
import dev.twister.explain.PixelPath;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.picture.PixelInspector.PixelReading;
import dev.twister.scene.Rgb;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.collections.FXCollections;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableView;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** The steps of a pixel's path with the numbers of the equation, and what each adds to the pixel. */
public final class PathTable extends VBox {
    /** Of the usual text, as the style sheet has it. */
    private static final double TEXT = 0.85;

    private static final int MOST_LIGHTS = 8;

    private final Label heading = new Label();
    private final BooleanProperty isTraced = new SimpleBooleanProperty();
    private final TableView<PathStep> table = new TableView<>();

    public PathTable(PathPick pick) {
        getStyleClass().add("path");
        setId("path");
        table.setId("path-steps");
        table.setFocusTraversable(false);
        table.setPlaceholder(new Region());
        column("Step", 3.2, step -> String.valueOf(table.getItems().indexOf(step) + 1));
        column("Ray", 8.2, this::ray);
        column("Meets", 5.5, step -> PixelReading.bodyName(pick.sceneBody(step.body())));
        column("Distance", 6, step -> step.distance() == 0 ? "" : number(step.distance()) + " m");
        lights("N·L", 3.9, LightPart::normalDotLight);
        lights("S", 3.6, LightPart::visible);
        shading("lit", 3.6, ShadedSurface::lit);
        lights("spec", 3.8, LightPart::specular);
        ofIntegrator(
                false,
                column(
                        "C",
                        9,
                        step -> step.shading()
                                .map(ShadedSurface::albedo)
                                .map(PathTable::color)
                                .orElse("")));
        shading("m", 3.6, ShadedSurface::mirror);
        shading("t", 3.6, ShadedSurface::transmission);
        shading("F", 3.6, ShadedSurface::reflectance);
        light("p surface", 5, light -> density(light.surfaceDensity()));
        light("p light", 5, light -> density(light.emitterDensity()));
        light("w", 3.6, light -> number(light.weight()));
        scattering(
                "Emitter",
                8.2,
                surface -> surface.emitter()
                        .map(chosen -> PixelReading.bodyName(pick.sceneBody(chosen.body())) + " "
                                + number(chosen.probability()))
                        .orElse(""));
        scattering(
                "Lobe",
                8.2,
                surface -> surface.next()
                        .map(next -> next.kind().id() + " " + number(next.probability()))
                        .orElse(""));
        scattering(
                "Survival",
                5,
                surface -> surface.next().map(next -> number(next.survival())).orElse(""));
        column("Throughput", 9, step -> color(step.throughput()));
        column("Adds", 9, step -> color(step.adds()));
        Button close = new Button("✕");
        close.setId("close-path");
        close.setFocusTraversable(false);
        close.setTooltip(Tooltips.of("Closes the path.\nKey: Esc"));
        close.setOnAction(_ -> pick.clear());
        heading.setId("path-heading");
        heading.setMinWidth(0);
        Region gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        HBox top = new HBox(heading, gap, close);
        top.setAlignment(Pos.CENTER_LEFT);
        VBox.setVgrow(table, Priority.ALWAYS);
        getChildren().addAll(top, table);
        setMaxHeight(USE_PREF_SIZE);
        managedProperty().bind(visibleProperty());
        pick.pathProperty().subscribe(this::show);
    }

    private void show(Optional<PixelPath> path) {
        setVisible(path.isPresent());
        isTraced.set(path.filter(PixelPath::isTraced).isPresent());
        heading.setText(path.map(PathTable::heading).orElse(""));
        table.setItems(
                FXCollections.observableArrayList(path.map(PixelPath::steps).orElseGet(List::of)));
    }

    private static String heading(PixelPath path) {
        return String.format(
                Locale.ROOT,
                "Path through the center of pixel x %d, y %d   radiance %s, the sum of what the steps add   RGB %d %d %d",
                path.column(),
                path.row(),
                color(path.radiance()),
                path.argb() >> 16 & 255,
                path.argb() >> 8 & 255,
                path.argb() & 255);
    }

    private String ray(PathStep step) {
        return step.parent() == PathStep.NO_PARENT
                ? step.kind().id()
                : step.kind().id() + " from " + (step.parent() + 1);
    }

    private void shading(String name, double width, ToDoubleFunction<ShadedSurface> value) {
        ofIntegrator(
                false,
                column(
                        name,
                        width,
                        step -> step.shading()
                                .map(shading -> number(value.applyAsDouble(shading)))
                                .orElse("")));
    }

    private void light(String name, double width, Function<FoundLight, String> text) {
        ofIntegrator(true, column(name, width, step -> step.light().map(text).orElse("")));
    }

    private void scattering(String name, double width, Function<Scattering, String> text) {
        ofIntegrator(
                true, column(name, width, step -> step.scattering().map(text).orElse("")));
    }

    /** Shows a column with paths of one integrator only. */
    private void ofIntegrator(boolean traced, TableColumn<PathStep, String> column) {
        column.visibleProperty().bind(isTraced.map(shown -> shown == traced));
    }

    /** With a line for each of the first lights. */
    private void lights(String name, double width, ToDoubleFunction<LightPart> value) {
        ofIntegrator(
                false,
                column(
                        name,
                        width,
                        step -> step.shading()
                                .map(shading -> shading.lights().stream()
                                        .limit(MOST_LIGHTS)
                                        .map(light -> number(value.applyAsDouble(light)))
                                        .collect(Collectors.joining("\n")))
                                .orElse("")));
    }

    /** Its width is in letters' heights. */
    private TableColumn<PathStep, String> column(String name, double width, Function<PathStep, String> text) {
        TableColumn<PathStep, String> column = new TableColumn<>(name);
        column.setCellValueFactory(cell -> new ReadOnlyStringWrapper(text.apply(cell.getValue())));
        column.setSortable(false);
        column.setReorderable(false);
        column.prefWidthProperty().bind(heading.fontProperty().map(font -> TEXT * width * font.getSize()));
        table.getColumns().add(column);
        return column;
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }

    private static String density(double value) {
        return value == 0 ? "" : String.format(Locale.ROOT, "%.4g", value);
    }

    private static String color(Rgb color) {
        return String.format(Locale.ROOT, "%.3f %.3f %.3f", color.red(), color.green(), color.blue());
    }
}
