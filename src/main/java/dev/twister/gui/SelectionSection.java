package dev.twister.gui;

import dev.twister.gui.ChoiceRow.Look;
import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyList;
import dev.twister.gui.model.BodyNumber;
import dev.twister.scene.Scene;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;

/** The selected sphere, where it is now if it moves. A reset leads back to how it was when it was selected. */
final class SelectionSection extends VBox {
    private static final long FOLLOW_NANOS = 100_000_000;

    private final Studio studio;
    private final ChoiceRow<Integer> bodies;
    private final Label hint = new Label();
    private List<NumberRow> numbers = List.of();
    private Scene atSelection;
    private long followedNanos;

    SelectionSection(Studio studio) {
        this.studio = studio;
        atSelection = studio.scene();
        getStyleClass().add("rows");
        hint.getStyleClass().add("hint");
        hint.setWrapText(true);
        hint.setId("selection-hint");
        bodies = new ChoiceRow<>(
                "Body",
                "The selected body. F2 selects the next one, a click in the picture the one that is seen there.",
                "Alt+Shift+O",
                body -> new Look(BodyList.name(studio.scene(), body)),
                studio::select,
                studio::notice);
        studio.selectionProperty().subscribe(_ -> rebuild());
        studio.selectionProperty().subscribe(_ -> listBodies());
        studio.sceneProperty().map(scene -> scene.spheres().size()).subscribe(_ -> listBodies());
        // A row's own edit is shown too, while the slider is held.
        studio.sceneProperty()
                .subscribe(_ -> refresh(
                        row -> !row.isRead() || !studio.motionProperty().get().isOn()));
        studio.motionProperty().subscribe(_ -> follow());
    }

    /** Called in every pulse: follows a sphere that moves, as fast as one reads, and where the panel is seen at all. */
    void pulse(long nanos) {
        if (studio.motionProperty().get().isOn() && nanos - followedNanos >= FOLLOW_NANOS) {
            followedNanos = nanos;
            follow();
        }
    }

    /** The list of bodies, and the rows of the sphere that is selected. */
    List<PanelRow> rows() {
        return Stream.concat(Stream.of(bodies), numbers.stream()).toList();
    }

    /** The list of all bodies, above the rest. */
    PanelRow bodies() {
        return bodies;
    }

    private void listBodies() {
        int selected = studio.selectionProperty().get();
        bodies.show(BodyList.of(studio.scene(), selected), selected, BodyNumber.NONE);
    }

    private void rebuild() {
        int body = studio.selectionProperty().get();
        if (studio.scene().spheres().size() != atSelection.spheres().size()) {
            // It would be taken as they lose the focus, for the sphere that has the number now.
            numbers.forEach(NumberRow::forgetTyped);
        }
        atSelection = studio.scene();
        boolean sphere = BodyEdits.isSphere(atSelection, body);
        numbers = sphere ? numbers(body) : List.of();
        hint.setText(hint(atSelection, body));
        getChildren().setAll(hint);
        getChildren().addAll(numbers);
        refresh(_ -> true);
    }

    private static String hint(Scene scene, int body) {
        int spheres = scene.spheres().size();
        if (BodyEdits.isPoured(scene, body)) {
            return "Poured sphere " + (BodyNumber.sphere(body) - spheres + 1)
                    + ". Physics moves it; it can't be edited.";
        }
        return switch (body) {
            case BodyNumber.NONE ->
                "Click a sphere, the light or the plane in the picture to select it, or press F2; drag the selected sphere "
                        + "or light to move it.";
            case BodyNumber.LIGHT -> "The light is selected; its controls are above.";
            case BodyNumber.PLANE -> "The plane is selected; its material is below.";
            default ->
                "Sphere " + (BodyNumber.sphere(body) + 1) + " of " + spheres
                        + ". Drag it to move it, Delete deletes it.";
        };
    }

    private List<NumberRow> numbers(int body) {
        return List.of(
                new NumberRow(BodyEdits.x(body), "Alt+4", studio),
                new NumberRow(BodyEdits.y(body), "Alt+5", studio),
                new NumberRow(BodyEdits.z(body), "Alt+6", studio),
                new NumberRow(BodyEdits.radiusOf(body), "Alt+7", studio));
    }

    private void follow() {
        refresh(row -> !row.isInHand());
    }

    private void refresh(Predicate<NumberRow> which) {
        Scene scene = studio.scene();
        int body = studio.selectionProperty().get();
        // The selection follows a scene that has lost the sphere; until then there is nothing to show.
        if (BodyEdits.isSphere(scene, body)) {
            Scene seen = studio.motionProperty().get().isOn()
                    ? BodyEdits.moved(scene, body, studio.positionNow(body))
                    : scene;
            numbers.stream().filter(which).forEach(row -> row.show(seen, atSelection));
        }
    }
}
