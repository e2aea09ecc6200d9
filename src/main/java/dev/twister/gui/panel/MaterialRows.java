package dev.twister.gui.panel;

import dev.twister.gui.controls.Ids;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.BodyTitles;
import dev.twister.gui.edit.MaterialPreset;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.gui.files.AssetActions;
import dev.twister.gui.files.FileNames;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.property.DerivedNumbers;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.format.TexturePlaces;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.Row;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javafx.scene.control.Button;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.layout.StackPane;

/** The rows of one body's material. A reset leads to the material at the time of the selection. */
final class MaterialRows {
    /** The color of half of the plane's squares. */
    private static final Property<Material, Rgb> FIRST_COLOR = MaterialProperties.COLOR.withRow(new Row(
            "First color",
            "The color of half of the squares.",
            MaterialProperties.COLOR.row().keys(),
            MaterialProperties.COLOR.row().slide(),
            Optional.empty()));

    private final Studio studio;
    private final AssetActions assets;
    private final int body;
    private final Scene before;
    private final ChoiceRow<Optional<MaterialPreset>> preset;
    private final List<PropertyRow> rows;
    private final SwitchRow all;
    private boolean changesAll;

    /** The selected bodies, which are edited together. */
    private SelectedBodies selected;

    /** The scene for which {@link #shared} and {@link #images} hold. */
    private Scene known;

    private Optional<BodyMaterials.Shared> shared;
    private List<Optional<Path>> images;

    /** Rows for the plane, a sphere, or a mesh that has a material of its own. */
    MaterialRows(Studio studio, AssetActions assets, int body) {
        this.studio = studio;
        this.assets = assets;
        this.body = body;
        selected = SelectedBodies.of(body);
        before = studio.scene();
        known = before;
        shared = BodyMaterials.Shared.of(before, body);
        images = images(before);
        preset = new ChoiceRow<>(
                "Preset",
                "A common material. What it does not name stays.",
                "Alt+Shift+M",
                choice -> new Look(choice.map(MaterialPreset::label).orElse("Custom")),
                choice -> edit(
                        "preset",
                        old -> choice.map(chosen -> chosen.appliedTo(old)).orElseGet(this::firstMaterial)),
                studio::notice);
        rows = Stream.concat(
                        MaterialProperties.ALL.stream().filter(this::isOfBody).flatMap(this::rows),
                        body == BodyNumber.PLANE ? PropertyRow.of(oddColor(), studio) : Stream.empty())
                .toList();
        all = new SwitchRow(
                "Change all",
                "Apply changes to every body with this named material. Off: to the selected body only.",
                "Alt+Shift+N",
                on -> {
                    changesAll = on;
                    show();
                });
    }

    int body() {
        return body;
    }

    /** Whether the body's number may mean another body by now. */
    boolean isRenumbered() {
        return BodyEdits.isRenumbered(before, studio.scene(), body);
    }

    List<PanelRow> rows() {
        // Only named materials are shared.
        List<SwitchRow> sharing = before.materials().isEmpty() ? List.of() : List.of(all);
        return Stream.of(Stream.of(preset), rows.stream().map(PropertyRow::row), sharing.stream())
                .<PanelRow>flatMap(all -> all)
                .toList();
    }

    void forgetTyped() {
        rows.forEach(PropertyRow::forgetTyped);
    }

    /** Text that names the material and the bodies that share it. */
    String hint() {
        return (body == BodyNumber.PLANE ? "The plane" : BodyTitles.title(studio.scene(), body))
                + shared.map(named -> " has the material \"" + named.name() + "\", "
                                + (named.bodies().size() == 1
                                        ? "alone."
                                        : "shared by " + named.bodies().size() + " bodies."))
                        .orElse(" has a material of its own.")
                + (selected.count() == 1 ? "" : " Changes apply to all selected bodies.");
    }

    /** Shows the material; the body must exist and be the active one. */
    void show() {
        selected = studio.selection().bodies();
        Scene scene = studio.scene();
        if (!BodyMaterials.areSame(scene, known)) {
            known = scene;
            shared = shared.filter(named -> named.isIn(scene)).or(() -> BodyMaterials.Shared.of(scene, body));
            images = images(scene);
        }
        Material now = material(scene);
        Optional<MaterialPreset> present = MaterialPreset.of(now);
        preset.show(presets(present), present, MaterialPreset.of(firstMaterial()));
        rows.forEach(row -> row.show(scene, before));
        all.show(changesAll && shared.isPresent(), false);
        all.setDisable(shared.isEmpty());
    }

    private Material material(Scene scene) {
        return BodyMaterials.of(scene, body);
    }

    private Material firstMaterial() {
        return material(before);
    }

    private Scene edited(Scene scene, UnaryOperator<Material> edit) {
        Scene sharing = shared.filter(_ -> changesAll)
                .map(named -> named.edited(scene, edit))
                .orElse(scene);
        return BodyMaterials.edited(sharing, selected.bodies(), edit);
    }

    private void edit(String what, UnaryOperator<Material> edit) {
        studio.editOnce(what, scene -> edited(scene, edit));
    }

    /** Only meshes are cut out, and the plane cannot emit. */
    private boolean isOfBody(Property<Material, ?> property) {
        return (!MaterialProperties.isOfMeshes(property) || BodyEdits.isMesh(before, body))
                && (!MaterialProperties.isOfEmission(property) || body != BodyNumber.PLANE);
    }

    @SuppressWarnings("unchecked") // a property's values are of its type
    private Stream<PropertyRow> rows(Property<Material, ?> property) {
        boolean even = body == BodyNumber.PLANE && property.equals(MaterialProperties.COLOR);
        Property<Scene, ?> inScene = (even ? FIRST_COLOR : property).in(this::material, this::edited);
        if (property.equals(MaterialProperties.REFLECTIVITY)) {
            NumberRow row = new NumberRow(DerivedNumbers.REFLECTIVITY.in(this::material, this::edited), studio);
            return Stream.of(new PropertyRow(
                    row,
                    (scene, usual) -> {
                        row.show(scene, usual);
                        row.showUnit(DerivedNumbers.percentUnit(material(scene)));
                    },
                    Optional.empty()));
        }
        return MaterialProperties.IMAGES.contains(property)
                ? Stream.of(image((Property<Scene, Optional<Path>>) inScene))
                : PropertyRow.of(inScene, studio);
    }

    private static Property<Scene, Rgb> oddColor() {
        return BodyProperties.ODD_COLOR.within(Scene::ground, Scene::withGround);
    }

    private static List<Optional<MaterialPreset>> presets(Optional<MaterialPreset> present) {
        return Stream.concat(
                        Arrays.stream(MaterialPreset.values()).map(Optional::of),
                        Stream.of(present).filter(Optional::isEmpty))
                .toList();
    }

    private PropertyRow image(Property<Scene, Optional<Path>> property) {
        Row text = property.row();
        Consumer<Path> use = file -> assets.readTexture(file, () -> set(property, Optional.of(file)), this::show);
        ChoiceRow<Optional<Path>> row = new ChoiceRow<>(
                text.label(),
                text.hint(),
                text.keys(),
                file -> {
                    String name = file.map(FileNames::name).orElse("None");
                    return new Look(name, name, file.map(Path::toString).orElse(""), Optional.empty());
                },
                file -> file.ifPresentOrElse(use, () -> set(property, Optional.empty())),
                studio::notice);
        Thumbnail thumbnail = new Thumbnail();
        row.addControl(thumbnail);
        Button other = new Button("Other…");
        other.setId("other-" + Ids.of(text.label()));
        other.setTooltip(Tooltips.of("Chooses an image file: .png, .jpg or .webp."));
        other.setOnAction(_ -> assets.chooseTexture(property.getter().apply(studio.scene()), use));
        row.addControl(other);
        return new PropertyRow(
                row,
                (scene, usual) -> {
                    Optional<Path> chosen = property.getter().apply(scene);
                    row.show(images, chosen, property.getter().apply(usual));
                    thumbnail.show(chosen);
                },
                text.only());
    }

    private void set(Property<Scene, Optional<Path>> property, Optional<Path> file) {
        studio.editOnce(
                property.row().label().toLowerCase(Locale.ROOT),
                scene -> property.wither().apply(scene, file));
    }

    /** No image, those of the scene, and those at the time of the selection. */
    private List<Optional<Path>> images(Scene scene) {
        return Stream.concat(
                        Stream.of(Optional.<Path>empty()),
                        Stream.concat(TexturePlaces.of(scene).keySet().stream(), firstMaterial().images().stream())
                                .distinct()
                                .sorted()
                                .map(Optional::of))
                .toList();
    }

    /** A small copy of an image; without one it takes no room. */
    private static final class Thumbnail extends StackPane {
        private static final double SIDE = 22;

        private final ImageView view = new ImageView();
        private Optional<Path> pictured = Optional.empty();

        Thumbnail() {
            view.setFitWidth(SIDE);
            view.setFitHeight(SIDE);
            view.setPreserveRatio(true);
            getChildren().add(view);
        }

        void show(Optional<Path> chosen) {
            if (!chosen.equals(pictured)) {
                pictured = chosen;
                // In the background, and empty where JavaFX does not know the format.
                view.setImage(
                        chosen.map(file -> new Image(file.toUri().toString(), 2 * SIDE, 2 * SIDE, true, true, true))
                                .orElse(null));
            }
            view.setManaged(chosen.isPresent());
        }
    }
}
