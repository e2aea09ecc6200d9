package dev.twister.gui.panel;

import dev.twister.gui.model.BodyChoices;
import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyMaterials;
import dev.twister.gui.model.BodyNumber;
import dev.twister.gui.model.BodyNumbers;
import dev.twister.gui.model.SelectedBodies;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;

/**
 * The bodies, which of them are selected, and the numbers of the active one, where it is now if it moves. A reset leads
 * back to how it was when it was selected.
 */
final class SelectionSection extends VBox {
    private static final long FOLLOW_NANOS = 100_000_000;

    private final Studio studio;
    private final BodiesRow bodies;
    private final Label hint = new Label();
    private List<NumberRow> numbers = List.of();
    private Scene atSelection;
    private int shownBody = BodyNumber.NONE;
    private Scene listed;
    private long followedNanos;

    SelectionSection(Studio studio) {
        this.studio = studio;
        atSelection = studio.scene();
        listed = studio.scene();
        getStyleClass().add("rows");
        hint.getStyleClass().add("hint");
        hint.setWrapText(true);
        hint.setId("selection-hint");
        bodies = new BodiesRow(studio);
        studio.selection().activeProperty().subscribe(_ -> rebuild());
        studio.selection().bodiesProperty().subscribe(_ -> {
            listBodies();
            showHint();
        });
        studio.sceneProperty().subscribe(scene -> {
            if (!BodyMaterials.areSame(scene, listed)) {
                listBodies();
            }
        });
        // A row's own edit is shown too, while the slider is held.
        studio.sceneProperty()
                .subscribe(_ -> refresh(row -> !row.isRead() || !studio.motion().isOn()));
        studio.motion().motionProperty().subscribe(_ -> follow());
    }

    /** Called in every pulse: follows a sphere that moves, as fast as one reads, and where the panel is seen at all. */
    void pulse(long nanos) {
        if (studio.motion().isOn() && nanos - followedNanos >= FOLLOW_NANOS) {
            followedNanos = nanos;
            follow();
        }
    }

    /** The list of bodies, and the rows of the one that is selected. */
    List<PanelRow> rows() {
        return Stream.concat(Stream.of(bodies), numbers.stream()).toList();
    }

    /** The list of all bodies, above the rest. */
    PanelRow bodies() {
        return bodies;
    }

    private void listBodies() {
        Scene scene = studio.scene();
        listed = scene;
        bodies.show(scene, studio.selection().bodies());
    }

    private void rebuild() {
        int body = studio.selection().active();
        if (BodyEdits.isRenumbered(atSelection, studio.scene(), shownBody)) {
            // It would be taken as they lose the focus, for the body that has the number now.
            numbers.forEach(NumberRow::forgetTyped);
        }
        shownBody = body;
        atSelection = studio.scene();
        numbers = numbers(atSelection, body);
        showHint();
        getChildren().setAll(hint);
        getChildren().addAll(numbers);
        refresh(_ -> true);
    }

    private void showHint() {
        SelectedBodies selected = studio.selection().bodies();
        hint.setText(
                selected.count() > 1
                        ? selected.count() + " bodies are selected. Drag one to move all, Delete deletes all. "
                                + (selected.active() == BodyNumber.LIGHT
                                        ? "The light is the active one."
                                        : "These numbers are of " + BodyChoices.title(studio.scene(), selected.active())
                                                + ".")
                        : hint(studio.scene(), selected.active()));
    }

    private static String hint(Scene scene, int body) {
        int spheres = scene.spheres().size();
        if (BodyEdits.isPoured(scene, body)) {
            return "Poured sphere " + (BodyNumber.sphere(body) - spheres + 1)
                    + ". Physics moves it; it can't be edited.";
        }
        return switch (body) {
            case BodyNumber.NONE ->
                "Click a body in the picture to select it, or press F2; Shift+click selects several. Drag a selected "
                        + "sphere, mesh or light to move it.";
            case BodyNumber.LIGHT -> "The light is selected; its controls are above.";
            case BodyNumber.PLANE -> "The plane is selected; its material is below.";
            default -> BodyChoices.title(scene, body) + of(scene, body) + ". Drag it to move it, Delete deletes it.";
        };
    }

    private static String of(Scene scene, int body) {
        int count = BodyEdits.isMesh(scene, body)
                ? scene.meshes().size()
                : scene.spheres().size();
        return count == 1 ? "" : " of " + count;
    }

    private List<NumberRow> numbers(Scene scene, int body) {
        if (!BodyEdits.isSolid(scene, body)) {
            return List.of();
        }
        boolean mesh = BodyEdits.isMesh(scene, body);
        BodyNumbers settings = mesh ? BodyNumbers.ofMesh(body) : BodyNumbers.ofSphere(body);
        List<NumberRow> rows = new ArrayList<>(List.of(
                new NumberRow(settings.x(), "Alt+4", studio),
                new NumberRow(settings.y(), "Alt+5", studio),
                new NumberRow(settings.z(), "Alt+6", studio)));
        if (mesh) {
            rows.add(new NumberRow(settings.yaw(), "Alt+Shift+4", studio));
            rows.add(new NumberRow(settings.pitch(), "Alt+Shift+5", studio));
            rows.add(new NumberRow(settings.roll(), "Alt+Shift+6", studio));
            rows.add(new NumberRow(settings.scale(), "Alt+7", studio));
        } else {
            rows.add(new NumberRow(settings.radius(), "Alt+7", studio));
        }
        return rows;
    }

    private void follow() {
        refresh(row -> !row.isInHand());
    }

    private void refresh(Predicate<NumberRow> which) {
        Scene scene = studio.scene();
        int body = studio.selection().active();
        // The selection follows a scene that has lost the body; until then there is nothing to show.
        if (BodyEdits.isSolid(scene, body) && body == shownBody) {
            Scene seen = studio.motion().isOn()
                    ? BodyEdits.moved(scene, body, studio.bodies().position(body))
                    : scene;
            numbers.stream().filter(which).forEach(row -> row.show(seen, atSelection));
        }
    }
}
