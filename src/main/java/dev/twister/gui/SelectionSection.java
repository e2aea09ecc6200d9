package dev.twister.gui;

import dev.twister.gui.ChoiceRow.Look;
import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyList;
import dev.twister.gui.model.BodyMaterials;
import dev.twister.gui.model.BodyNumber;
import dev.twister.gui.model.BodyNumbers;
import dev.twister.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;

/** The selected sphere or mesh, where it is now if it moves. A reset leads back to how it was when it was selected. */
final class SelectionSection extends VBox {
    private static final long FOLLOW_NANOS = 100_000_000;

    private final Studio studio;
    private final ChoiceRow<Named> bodies;
    private final Label hint = new Label();
    private List<NumberRow> numbers = List.of();
    private Scene atSelection;
    private int shownBody = BodyNumber.NONE;
    private Scene listed;
    private long followedNanos;

    /** A body in the list. */
    private record Named(int body, String name) {
        static Named of(Scene scene, int body) {
            return new Named(body, BodyList.name(scene, body));
        }
    }

    SelectionSection(Studio studio) {
        this.studio = studio;
        atSelection = studio.scene();
        listed = studio.scene();
        getStyleClass().add("rows");
        hint.getStyleClass().add("hint");
        hint.setWrapText(true);
        hint.setId("selection-hint");
        bodies = new ChoiceRow<>(
                "Body",
                "The selected body. F2 selects the next one, a click in the picture the one that is seen there.",
                "Alt+Shift+O",
                named -> new Look(named.name()),
                named -> studio.select(named.body()),
                studio::notice);
        studio.selectionProperty().subscribe(_ -> rebuild());
        studio.selectionProperty().subscribe(_ -> listBodies());
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
        int selected = studio.selectionProperty().get();
        listed = scene;
        bodies.show(
                BodyList.of(scene, selected).stream()
                        .map(body -> Named.of(scene, body))
                        .toList(),
                Named.of(scene, selected),
                Named.of(scene, BodyNumber.NONE));
    }

    private void rebuild() {
        int body = studio.selectionProperty().get();
        if (BodyEdits.isRenumbered(atSelection, studio.scene(), shownBody)) {
            // It would be taken as they lose the focus, for the body that has the number now.
            numbers.forEach(NumberRow::forgetTyped);
        }
        shownBody = body;
        atSelection = studio.scene();
        numbers = numbers(atSelection, body);
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
                "Click a body in the picture to select it, or press F2; drag the selected sphere, mesh or light to move "
                        + "it.";
            case BodyNumber.LIGHT -> "The light is selected; its controls are above.";
            case BodyNumber.PLANE -> "The plane is selected; its material is below.";
            default -> BodyList.title(scene, body) + of(scene, body) + ". Drag it to move it, Delete deletes it.";
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
        int body = studio.selectionProperty().get();
        // The selection follows a scene that has lost the body; until then there is nothing to show.
        if (BodyEdits.isSolid(scene, body) && body == shownBody) {
            Scene seen = studio.motion().isOn() ? BodyEdits.moved(scene, body, studio.positionNow(body)) : scene;
            numbers.stream().filter(which).forEach(row -> row.show(seen, atSelection));
        }
    }
}
