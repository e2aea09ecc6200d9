package dev.twister.gui.panel;

import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.BodyTitles;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.gui.edit.TagEdits;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.Studio;
import dev.twister.gui.studio.TagActions;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Scene;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.PropertyType;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;

/**
 * The list of bodies and the numbers of the active one, where it is now if it moves. A reset leads to the numbers at
 * the time of the selection.
 */
final class SelectionSection extends VBox {
    private static final long FOLLOW_NANOS = 100_000_000;

    private final Studio studio;
    private final BodiesRow bodies;
    private final Label hint = new Label();
    private List<NumberRow> numbers = List.of();
    private Optional<AnimationRows> animation = Optional.empty();
    private Scene atSelection;
    private int shownBody = BodyNumber.NONE;
    private Scene listed;
    private long followedNanos;

    SelectionSection(Studio studio, TagActions tags) {
        this.studio = studio;
        atSelection = studio.scene();
        listed = studio.scene();
        getStyleClass().add("rows");
        hint.getStyleClass().add("hint");
        hint.setWrapText(true);
        hint.setId("selection-hint");
        bodies = new BodiesRow(studio, tags);
        studio.selection().activeProperty().subscribe(_ -> rebuild());
        studio.selection().bodiesProperty().subscribe(_ -> {
            listBodies();
            showHint();
        });
        studio.sceneProperty().subscribe(scene -> {
            if (!BodyMaterials.areSame(scene, listed) || !TagEdits.areSame(scene, listed)) {
                listBodies();
                showHint();
            }
        });
        // Rows follow edits also while their slider is held.
        studio.sceneProperty()
                .subscribe(_ -> refresh(row -> !row.isRead() || !studio.motion().isOn()));
        studio.motion().motionProperty().subscribe(_ -> follow());
        studio.sceneProperty().subscribe(_ -> followAnimation());
        // The animations of a file are known once it has been read.
        studio.pictureProperty().subscribe(_ -> followAnimation());
    }

    /** Called in every pulse: follows a moving sphere, a few times a second and only if the panel is visible. */
    void pulse(long nanos) {
        if (studio.motion().isOn() && nanos - followedNanos >= FOLLOW_NANOS) {
            followedNanos = nanos;
            follow();
        }
    }

    /** The list of bodies, and the rows of the active one. */
    List<PanelRow> rows() {
        return Stream.of(Stream.of(bodies), numbers.stream(), animation.stream().flatMap(AnimationRows::rows))
                .<PanelRow>flatMap(rows -> rows)
                .toList();
    }

    /** The list of bodies. */
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
            // A field that loses the focus enters its text, now for the body that has taken over the number.
            numbers.forEach(NumberRow::forgetTyped);
        }
        shownBody = body;
        atSelection = studio.scene();
        showHint();
        showRows();
    }

    private void showRows() {
        numbers = NumberRow.of(PropertyNumbers.ofBody(studio.scene(), shownBody), studio);
        animation = Clips.of(studio, shownBody).map(clips -> new AnimationRows(studio, clips));
        getChildren().setAll(hint);
        getChildren().addAll(numbers);
        animation.ifPresent(rows -> getChildren().addAll(rows.rows().toList()));
        refresh(_ -> true);
    }

    /** Shows other rows if the active mesh plays an animation since, or no longer, or its file has been read. */
    private void followAnimation() {
        if (shownBody == studio.selection().active()
                && !Clips.of(studio, shownBody).equals(animation.map(rows -> rows.clips))) {
            showRows();
        }
    }

    private void showHint() {
        SelectedBodies selected = studio.selection().bodies();
        hint.setText(
                selected.count() > 1
                        ? selected.count() + " bodies are selected. Drag one to move all, Delete deletes all. "
                                + (BodyEdits.isLight(studio.scene(), selected.active())
                                        ? BodyTitles.title(studio.scene(), selected.active()) + " is the active one."
                                        : "These numbers are of " + BodyTitles.title(studio.scene(), selected.active())
                                                + ".")
                        : hint(studio.scene(), selected.active()));
    }

    private static String hint(Scene scene, int body) {
        int spheres = scene.spheres().size();
        if (BodyEdits.isPoured(scene, body)) {
            return "Poured sphere " + (BodyNumber.sphere(body) - spheres + 1)
                    + ". Physics moves it; it can't be edited.";
        }
        if (BodyEdits.isLight(scene, body)) {
            return BodyTitles.title(scene, body) + " is selected; its controls are under Light.";
        }
        return switch (body) {
            case BodyNumber.NONE ->
                "Click a body in the picture to select it, or press F2; Shift+click selects several. Drag a selected "
                        + "sphere, mesh or light to move it.";
            case BodyNumber.PLANE -> "The plane is selected; its material is below.";
            default -> BodyTitles.title(scene, body) + of(scene, body) + ". Drag it to move it, Delete deletes it.";
        };
    }

    private static String of(Scene scene, int body) {
        int count = BodyEdits.isMesh(scene, body)
                ? scene.meshes().size()
                : scene.spheres().size();
        return count == 1 || !TagEdits.of(scene, body).name().isEmpty() ? "" : " of " + count;
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
            animation.ifPresent(rows -> rows.show(scene, atSelection));
        }
    }

    /**
     * The animations of a mesh's file.
     *
     * @param names the first one is empty, for none
     * @param plays whether the mesh plays one
     */
    private record Clips(int body, List<String> names, boolean plays) {
        /** Empty unless the body is a mesh of a file that is known to have animations. */
        static Optional<Clips> of(Studio studio, int body) {
            Scene scene = studio.scene();
            if (!BodyEdits.isMesh(scene, body)) {
                return Optional.empty();
            }
            Mesh mesh = BodyEdits.mesh(scene, body);
            List<String> clips = studio.bodies().meshes().clips(mesh);
            return Optional.of(new Clips(
                            body,
                            Stream.concat(Stream.of(""), clips.stream()).toList(),
                            !mesh.animation().isNone()))
                    .filter(_ -> !clips.isEmpty());
        }

        /** The chosen one; a number stands for the name that the animation has. */
        String shown(Scene scene) {
            String chosen = BodyEdits.isMesh(scene, body)
                    ? BodyEdits.mesh(scene, body).animation().name()
                    : "";
            boolean isNumber = !names.contains(chosen) && chosen.matches("\\d{1,9}");
            int place = isNumber ? 1 + Integer.parseInt(chosen) : 0;
            return isNumber && place < names.size() ? names.get(place) : chosen;
        }
    }

    /** Which animation of its file a mesh plays, and whether that loops. */
    private static final class AnimationRows {
        private static final Property<MeshAnimation, String> NAME = BodyProperties.ANIMATION_NAME;

        private final Clips clips;
        private final ChoiceRow<String> name;
        private final List<PropertyRow> others;

        AnimationRows(Studio studio, Clips clips) {
            this.clips = clips;
            name = new ChoiceRow<>(
                    NAME.row().label(),
                    NAME.row().hint(),
                    NAME.row().keys(),
                    chosen -> new Look(chosen.isEmpty() ? "None" : chosen),
                    chosen -> choose(studio, chosen),
                    studio::notice);
            others = clips.plays()
                    ? BodyProperties.ANIMATION.stream()
                            .filter(property -> property.type() instanceof PropertyType.Flag)
                            .flatMap(property -> PropertyRow.of(ofBody(property), studio))
                            .toList()
                    : List.of();
        }

        Stream<PanelRow> rows() {
            return Stream.concat(Stream.of(name), others.stream().map(PropertyRow::row));
        }

        void show(Scene scene, Scene usual) {
            name.show(clips.names(), clips.shown(scene), clips.shown(usual));
            others.forEach(row -> row.show(scene, usual));
        }

        private void choose(Studio studio, String chosen) {
            studio.editOnce(
                    "animation",
                    scene -> chosen.isEmpty()
                            ? BodyEdits.editedMesh(
                                    untracked(scene), clips.body(), mesh -> mesh.withAnimation(MeshAnimation.NONE))
                            : ofBody(NAME).wither().apply(scene, chosen));
            if (!chosen.isEmpty()) {
                studio.film().shownProperty().set(true);
            }
        }

        private Scene untracked(Scene scene) {
            return scene.withTracks(scene.tracks().stream()
                    .filter(track -> !track.target().equals(TrackTarget.mesh(BodyNumber.mesh(clips.body())))
                            || !track.property().startsWith("animation."))
                    .toList());
        }

        private <V> Property<Scene, V> ofBody(Property<MeshAnimation, V> property) {
            return property.within(Mesh::animation, Mesh::withAnimation)
                    .in(
                            scene -> BodyEdits.mesh(scene, clips.body()),
                            (scene, edit) -> BodyEdits.editedMesh(scene, clips.body(), edit));
        }
    }
}
