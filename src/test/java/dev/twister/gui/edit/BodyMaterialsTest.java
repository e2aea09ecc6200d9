package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.property.DerivedNumbers;
import dev.twister.gui.property.NumberProperty;
import dev.twister.kernel.Layout;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Maps;
import dev.twister.scene.material.Reflectance;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.SequencedMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class BodyMaterialsTest {
    private static final int FIRST = Layout.FIRST_SPHERE;
    private static final Material GLASS = Material.DEFAULT.withTransmission(1);
    private static final Material STEEL = Material.DEFAULT.withReflectivity(104);

    /** The plane and the first sphere of glass, the second of steel, the third of its own. */
    private final Scene scene = scene();

    private static Scene scene() {
        SequencedMap<String, Material> materials = new LinkedHashMap<>();
        materials.put("glass", GLASS);
        materials.put("steel", STEEL);
        Scene empty = Scene.under(Path.of("sky.hdr")).withMaterials(materials);
        return empty.withGround(empty.ground().withMaterial(GLASS))
                .withSpheres(List.of(ball(GLASS), ball(STEEL), ball(STEEL.withIor(2))));
    }

    private static Sphere ball(Material material) {
        return Sphere.of(new Vector3(0, 0, 0), 1, new Rgb(1, 1, 1), 0).withMaterial(material);
    }

    @Test
    void oneBodyIsEditedAlone() {
        Scene edited = BodyMaterials.edited(scene, FIRST, old -> old.withRoughness(0.5));

        assertThat(BodyMaterials.of(edited, FIRST)).isEqualTo(GLASS.withRoughness(0.5));
        assertThat(BodyMaterials.edited(edited, FIRST, _ -> GLASS)).isEqualTo(scene);
        Scene planes = BodyMaterials.edited(scene, Layout.PLANE, old -> old.withRoughness(0.5));
        assertThat(planes.ground().material()).isEqualTo(GLASS.withRoughness(0.5));
        assertThat(planes.spheres()).isEqualTo(scene.spheres());
    }

    @Test
    void aNamedMaterialIsEditedForAllThatHaveIt() {
        BodyMaterials.Shared glass = BodyMaterials.Shared.of(scene, FIRST).orElseThrow();

        assertThat(glass).isEqualTo(new BodyMaterials.Shared("glass", List.of(Layout.PLANE, FIRST)));
        Scene edited = glass.edited(scene, old -> old.withRoughness(0.5));
        assertThat(edited.materials()).containsEntry("glass", GLASS.withRoughness(0.5));
        assertThat(edited.ground().material()).isEqualTo(GLASS.withRoughness(0.5));
        assertThat(glass.isIn(edited)).isTrue();
        assertThat(glass.edited(edited, _ -> GLASS)).isEqualTo(scene);
    }

    @Test
    void aMaterialThatComesToEqualAnotherOneOnTheWayTakesNoBodyOfItAlong() {
        BodyMaterials.Shared glass = BodyMaterials.Shared.of(scene, FIRST).orElseThrow();

        Scene met = glass.edited(scene, _ -> STEEL);
        Scene beyond = glass.edited(met, _ -> GLASS);

        assertThat(beyond).isEqualTo(scene);
    }

    @Test
    void aBodyWithAMaterialOfItsOwnSharesNone() {
        assertThat(BodyMaterials.Shared.of(scene, FIRST + 2)).isEmpty();
        BodyMaterials.Shared glass = BodyMaterials.Shared.of(scene, FIRST).orElseThrow();
        assertThat(glass.isIn(BodyMaterials.edited(scene, FIRST, _ -> STEEL))).isFalse();
        assertThat(glass.isIn(scene.withSpheres(List.of()))).isFalse();
    }

    @ParameterizedTest
    @EnumSource
    void aPresetIsKnownAgainWhateverTheTexture(MaterialPreset preset) {
        Material painted = STEEL.withColor(new Rgb(1, 0, 0)).withTexture(Path.of("earth.png"));

        Material applied = preset.appliedTo(painted);

        assertThat(MaterialPreset.of(applied)).contains(preset);
        assertThat(applied.texture()).isEqualTo(painted.texture());
    }

    @Test
    void aPresetMirrorsByFresnelsEquationsAlsoWhereNothingWasMirrored() {
        Material dull = Material.DEFAULT.withReflectance(Reflectance.CONSTANT);

        assertThat(MaterialPreset.PLASTIC.appliedTo(dull).reflectance()).isEqualTo(Reflectance.MIXED);
    }

    @ParameterizedTest
    @EnumSource
    void aPresetKeepsWhatItDoesNotName(MaterialPreset preset) {
        Material lamp =
                MaterialPreset.LAMP.appliedTo(STEEL).withMaps(Maps.NONE.withNormal(ImageMap.of(Path.of("bricks.png"))));

        Material applied = preset.appliedTo(lamp);

        assertThat(applied.emission()).isEqualTo(lamp.emission());
        assertThat(applied.maps()).isEqualTo(lamp.maps());
        assertThat(MaterialPreset.PLASTIC.appliedTo(lamp).color()).isEqualTo(lamp.color());
    }

    @Test
    void reflectivityIsPerCentWithTheFilesNumberBesideIt() {
        NumberProperty<Scene> setting = DerivedNumbers.REFLECTIVITY.in(
                scene -> BodyMaterials.of(scene, FIRST + 1),
                (scene, edit) -> BodyMaterials.edited(scene, FIRST + 1, edit));

        assertThat(setting.scale().text(setting.read(scene))).isEqualTo("81.3");
        assertThat(DerivedNumbers.percentUnit(STEEL)).isEqualTo("% (p 104)");
        Scene edited = setting.write(scene, 33.3);
        assertThat(BodyMaterials.of(edited, FIRST + 1).reflectivity()).isEqualTo(42.624);
        assertThat(DerivedNumbers.percentUnit(BodyMaterials.of(edited, FIRST + 1)))
                .isEqualTo("% (p 42.62)");
    }

    @Test
    void theRoundOfBodiesHasNothingTheLightThePlaneAndTheSpheres() {
        assertThat(BodyEdits.along(scene, BodyNumber.NONE, 1)).isEqualTo(BodyNumber.LIGHT);
        assertThat(BodyEdits.along(scene, BodyNumber.LIGHT, 1)).isEqualTo(BodyNumber.PLANE);
        assertThat(BodyEdits.along(scene, BodyNumber.PLANE, 1)).isEqualTo(FIRST);
        assertThat(BodyEdits.along(scene, FIRST + 2, 1)).isEqualTo(BodyNumber.NONE);
        assertThat(BodyEdits.along(scene, BodyNumber.NONE, -1)).isEqualTo(FIRST + 2);
    }
}
