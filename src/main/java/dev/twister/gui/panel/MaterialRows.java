package dev.twister.gui.panel;

import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.BodyTitles;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.gui.edit.SharedMaterial;
import dev.twister.gui.files.AssetActions;
import dev.twister.gui.files.FileNames;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.property.MaterialNumbers;
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

/** The rows of one body's material. A reset leads to the material at the time of the selection. */
final class MaterialRows {
    private final Studio studio;
    private final AssetActions assets;
    private final int body;
    private final Scene before;
    private final ChoiceRow<Optional<BodyMaterials.Preset>> preset;
    private final List<ColorRow> colors;
    private final NumberRow reflectivity;
    private final List<NumberRow> numbers;
    private final ChoiceRow<Optional<Path>> texture;
    private final SwitchRow all;
    private boolean changesAll;

    /** The selected bodies, which are edited together. */
    private SelectedBodies selected;

    /** The scene for which {@link #shared} and {@link #textures} hold. */
    private Scene known;

    private Optional<SharedMaterial> shared;
    private List<Optional<Path>> textures;

    /** Rows for the plane, a sphere, or a mesh that has a material of its own. */
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
                choice -> new Look(choice.map(BodyMaterials.Preset::label).orElse("Custom")),
                choice -> edit(
                        "preset",
                        old -> choice.map(chosen -> chosen.appliedTo(old))
                                .orElseGet(() -> withTexture(firstMaterial().withColor(old.color()), old.texture()))),
                studio::notice);
        colors = colors();
        numbers = NumberRow.of(
                MaterialNumbers.ALL.stream()
                        .map(number -> number.in(this::material, this::edited))
                        .toList(),
                studio);
        reflectivity = numbers.get(MaterialNumbers.ALL.indexOf(MaterialNumbers.REFLECTIVITY));
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

    /** Whether the body's number may mean another body by now. */
    boolean isRenumbered() {
        return BodyEdits.isRenumbered(before, studio.scene(), body);
    }

    List<PanelRow> rows() {
        // Only named materials are shared.
        List<SwitchRow> sharing = before.materials().isEmpty() ? List.of() : List.of(all);
        return Stream.<List<? extends PanelRow>>of(List.of(preset), colors, numbers, List.of(texture), sharing)
                .<PanelRow>flatMap(List::stream)
                .toList();
    }

    void forgetTyped() {
        numbers.forEach(NumberRow::forgetTyped);
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
            shared = shared.filter(named -> named.isIn(scene)).or(() -> SharedMaterial.of(scene, body));
            textures = textures(scene);
        }
        Material now = material(scene);
        Optional<BodyMaterials.Preset> present = BodyMaterials.Preset.of(now);
        preset.show(presets(present), present, BodyMaterials.Preset.of(firstMaterial()));
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

    private static List<Optional<BodyMaterials.Preset>> presets(Optional<BodyMaterials.Preset> present) {
        return Stream.concat(
                        Arrays.stream(BodyMaterials.Preset.values()).map(Optional::of),
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

    private static Material withTexture(Material material, Optional<Path> file) {
        return file.map(material::withTexture).orElseGet(material::withoutTexture);
    }

    private void setTexture(Optional<Path> file) {
        edit("texture", old -> withTexture(old, file));
    }

    /** No texture, those of the scene, and the one at the time of the selection. */
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
