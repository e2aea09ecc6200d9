package dev.twister.gui.panel;

import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.files.AssetActions;
import dev.twister.gui.files.FileNames;
import dev.twister.gui.model.BodyChoices;
import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyMaterials;
import dev.twister.gui.model.BodyNumber;
import dev.twister.gui.model.MaterialNumbers;
import dev.twister.gui.model.MaterialPreset;
import dev.twister.gui.model.SelectedBodies;
import dev.twister.gui.model.SharedMaterial;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.format.TexturePlaces;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javafx.scene.control.Button;

/** The rows of one body's material. A reset leads back to how it was at first. */
final class MaterialRows {
    private final Studio studio;
    private final AssetActions assets;
    private final int body;
    private final Scene before;
    private final ChoiceRow<Optional<MaterialPreset>> preset;
    private final List<ColorRow> colors;
    private final NumberRow reflectivity;
    private final List<NumberRow> numbers;
    private final ChoiceRow<Optional<Path>> texture;
    private final SwitchRow all;
    private boolean changesAll;

    /** Those that are selected with the body: they are changed alike. */
    private SelectedBodies selected;

    /** Of which these are known: no camera changes them. */
    private Scene known;

    private Optional<SharedMaterial> shared;
    private List<Optional<Path>> textures;

    /** The material of the plane, of a sphere, or the own one of a mesh. */
    MaterialRows(Studio studio, AssetActions assets, int body) {
        this.studio = studio;
        this.assets = assets;
        this.body = body;
        selected = SelectedBodies.of(body);
        before = studio.scene();
        known = before;
        shared = SharedMaterial.of(before, body);
        textures = textures(before);
        preset = new ChoiceRow<>(
                "Preset",
                "A common material. Color and texture stay.",
                "Alt+Shift+M",
                choice -> new Look(choice.map(MaterialPreset::label).orElse("Custom")),
                choice -> edit(
                        "preset",
                        old -> choice.map(chosen -> chosen.appliedTo(old))
                                .orElseGet(() ->
                                        firstMaterial().withColor(old.color()).withTexture(old.texture()))),
                studio::notice);
        colors = colors();
        MaterialNumbers material = new MaterialNumbers(this::material, this::edited);
        reflectivity = new NumberRow(material.reflectivity(), "Alt+8", studio);
        numbers = List.of(
                reflectivity,
                new NumberRow(material.roughness(), "Alt+Shift+R", studio),
                new NumberRow(material.transmission(), "Alt+Shift+T", studio),
                new NumberRow(material.ior(), "Alt+Shift+I", studio));
        texture = texture();
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

    /** Whether the body's number may mean another one by now. */
    boolean isRenumbered() {
        return BodyEdits.isRenumbered(before, studio.scene(), body);
    }

    List<PanelRow> rows() {
        // Nothing is shared where nothing has a name.
        List<SwitchRow> sharing = before.materials().isEmpty() ? List.of() : List.of(all);
        return Stream.<List<? extends PanelRow>>of(List.of(preset), colors, numbers, List.of(texture), sharing)
                .<PanelRow>flatMap(List::stream)
                .toList();
    }

    void forgetTyped() {
        numbers.forEach(NumberRow::forgetTyped);
    }

    /** What the material is called, and who has it. */
    String hint() {
        return (body == BodyNumber.PLANE ? "The plane" : BodyChoices.title(before, body))
                + shared.map(named -> " has the material \"" + named.name() + "\", "
                                + (named.bodies().size() == 1
                                        ? "alone."
                                        : "shared by " + named.bodies().size() + " bodies."))
                        .orElse(" has a material of its own.")
                + (selected.count() == 1 ? "" : " Changes apply to all selected bodies.");
    }

    /** Shows the scene's material; the scene has the body, and it is the active one. */
    void show() {
        selected = studio.selection().bodies();
        Scene scene = studio.scene();
        if (!BodyMaterials.areSame(scene, known)) {
            known = scene;
            shared = shared.filter(named -> named.isIn(scene)).or(() -> SharedMaterial.of(scene, body));
            textures = textures(scene);
        }
        Material now = material(scene);
        Optional<MaterialPreset> present = MaterialPreset.of(now);
        preset.show(presets(present), present, MaterialPreset.of(firstMaterial()));
        colors.forEach(row -> row.show(scene, before));
        numbers.forEach(row -> row.show(scene, before));
        reflectivity.showUnit(MaterialNumbers.percentUnit(now));
        texture.show(textures, now.texture(), firstMaterial().texture());
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
        studio.edit(what, scene -> edited(scene, edit));
        studio.endGesture();
    }

    private List<ColorRow> colors() {
        boolean plane = body == BodyNumber.PLANE;
        ColorRow color = new ColorRow(
                plane ? "First color" : "Color",
                plane ? "The color of half of the squares." : "The color of the surface.",
                "Alt+9",
                studio,
                scene -> material(scene).color(),
                (scene, rgb) -> edited(scene, old -> old.withColor(rgb)));
        ColorRow odd = new ColorRow(
                "Second color",
                "The color of the other squares.",
                "Alt+Shift+C",
                studio,
                scene -> scene.ground().oddColor(),
                (scene, rgb) -> scene.withGround(scene.ground().withOddColor(rgb)));
        return plane ? List.of(color, odd) : List.of(color);
    }

    private static List<Optional<MaterialPreset>> presets(Optional<MaterialPreset> present) {
        return Stream.concat(
                        Arrays.stream(MaterialPreset.values()).map(Optional::of),
                        Stream.of(present).filter(Optional::isEmpty))
                .toList();
    }

    private ChoiceRow<Optional<Path>> texture() {
        ChoiceRow<Optional<Path>> row = new ChoiceRow<>(
                "Texture",
                "A picture that multiplies the color.",
                "Alt+Shift+X",
                file -> {
                    String name = file.map(FileNames::name).orElse("None");
                    return new Look(name, name, file.map(Path::toString).orElse(""), Optional.empty());
                },
                file -> file.ifPresentOrElse(this::useTexture, () -> setTexture(Optional.empty())),
                studio::notice);
        Button other = new Button("Other…");
        other.setId("other-texture");
        other.setTooltip(Tooltips.of("Chooses a texture file: .png or .jpg."));
        other.setOnAction(_ -> assets.chooseTexture(material(studio.scene()).texture(), this::useTexture));
        row.addControl(other);
        return row;
    }

    private void useTexture(Path file) {
        assets.readTexture(file, () -> setTexture(Optional.of(file)), this::show);
    }

    private void setTexture(Optional<Path> file) {
        edit("texture", old -> old.withTexture(file));
    }

    /** None, those that the scene has, and that of before. */
    private List<Optional<Path>> textures(Scene scene) {
        return Stream.concat(
                        Stream.of(Optional.<Path>empty()),
                        Stream.concat(TexturePlaces.of(scene).keySet().stream(), firstMaterial().texture().stream())
                                .distinct()
                                .sorted()
                                .map(Optional::of))
                .toList();
    }
}
