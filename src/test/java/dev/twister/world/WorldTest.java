package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.kernel.Layout;
import dev.twister.kernel.ToneMapping;
import dev.twister.scene.Camera;
import dev.twister.scene.Pour;
import dev.twister.scene.ToneMap;
import dev.twister.scene.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WorldTest {
    private final World world = Worlds.world();

    @Test
    void bodiesStandInTheirPlaces() {
        FrameInput input = world.snapshot();
        assertThat(input.bodies()).isEqualTo(4);
        assertThat(input.bodyPositions()).containsExactly(4, 5, 6, 0, 12, 0, 20, 21, 22, 28, 29, 30);
        assertThat(input.bodySizes()).containsExactly(7, 11, 23, 31);
        assertThat(input.bodyColors())
                .containsExactly(8, 9, 10, 0.13f, 0.14f, 0.15f, 0.24f, 0.25f, 0.26f, 0.32f, 0.33f, 0.34f);
        assertThat(input.bodyReflectivities()).containsExactly(0, 19, 27, 35);
    }

    @Test
    void settingsStandInTheirPlaces() {
        world.setSettings(world.settings().withTone(3, ToneMap.ACES, true));
        float[] properties = world.snapshot().rayTracingProperties();
        assertThat(properties).containsExactly(5, 6, 3, 8, ToneMapping.ACES, 1, 0.36f, 0.16f, 0.17f, 0.18f);
    }

    @ParameterizedTest
    @CsvSource({"CLAMP, 0", "REINHARD, 1", "ACES, 2"})
    void toneMapsHaveTheKernelsNumbers(ToneMap toneMap, float number) {
        world.setSettings(world.settings().withTone(0, toneMap, false));
        assertThat(world.snapshot().rayTracingProperties()[Layout.TONE_MAP]).isEqualTo(number);
    }

    @Test
    void movedBodiesAreInALaterSnapshotOnly() {
        FrameInput before = world.snapshot();
        float[] moved = before.bodyPositions().clone();
        moved[6] = 99;
        world.setBodyPositions(moved, 3);
        assertThat(before.bodyPositions()[6]).isEqualTo(20);
        assertThat(before.bodies()).isEqualTo(4);
        assertThat(world.snapshot().bodyPositions()).isSameAs(moved);
        assertThat(world.snapshot().bodies()).isEqualTo(3);
    }

    @Test
    void hierarchyFollowsTheBodies() {
        FrameInput before = world.snapshot();
        assertThat(world.snapshot().hierarchy()).isSameAs(before.hierarchy());
        float[] moved = before.bodyPositions().clone();
        moved[6] = 99;
        world.setBodyPositions(moved, 3);
        assertThat(world.snapshot().hierarchy())
                .isEqualTo(SphereHierarchy.of(moved, before.bodySizes(), 3))
                .hasSameSizeAs(before.hierarchy())
                .isNotEqualTo(before.hierarchy());
    }

    @Test
    void refusesPositionsThatDoNotFit() {
        assertThatThrownBy(() -> world.setBodyPositions(new float[9], 3))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("9 coordinates for 4 bodies");
        float[] positions = world.snapshot().bodyPositions();
        assertThatThrownBy(() -> world.setBodyPositions(positions, 5))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("5 bodies of 4");
        assertThatThrownBy(() -> world.setBodyPositions(positions, 1)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void whatIsPouredIsNotThereAtTheStart() {
        Pour pour = Pour.DEFAULT
                .withCount(5)
                .withRate(1)
                .withPosition(new Vector3(1, 2, 3))
                .withWidth(1)
                .withSpeed(1)
                .withRadii(0.1, 0.1);
        FrameInput input = World.of(Worlds.scene().withPour(pour), Worlds.SKY).snapshot();
        assertThat(input.bodies()).isEqualTo(4);
        assertThat(input.bodySizes()).hasSize(9).endsWith(0.1f);
        assertThat(input.bodyPositions()).hasSize(27);
    }

    @Test
    void fewSpheresAreFewOnlyWhereNoMoreWillCome() {
        Pour pour = Pour.DEFAULT
                .withCount(100)
                .withRate(1)
                .withPosition(new Vector3(1, 2, 3))
                .withWidth(1)
                .withSpeed(1)
                .withRadii(0.1, 0.1);

        assertThat(world.snapshot().hasFewSpheres()).isTrue();
        assertThat(World.of(Worlds.scene().withPour(pour), Worlds.SKY)
                        .snapshot()
                        .hasFewSpheres())
                .isFalse();
    }

    @Test
    void skyIsTheSkyboxItself() {
        FrameInput input = world.snapshot();
        assertThat(input.skybox()).isSameAs(Worlds.SKY.radiance());
        assertThat(input.skyboxDimensions()).containsExactly(2, 1);
    }

    @Test
    void pictureIsDrawnWhole() {
        assertThat(world.snapshot().dimensions()).containsExactly(40, 30, 0, 30, 4);
    }

    @Test
    void arraysThatStillHoldAreTheSameOnes() {
        FrameInput before = world.snapshot();
        world.setCamera(Camera.of(new Vector3(-1, -2, -3), 1, 2, 30));
        world.setSettings(world.settings().withBounces(1).withSize(8, 9));
        FrameInput after = world.snapshot();
        assertThat(after.bodyPositions()).isSameAs(before.bodyPositions());
        assertThat(after.bodySizes()).isSameAs(before.bodySizes());
        assertThat(after.bodyColors()).isSameAs(before.bodyColors());
        assertThat(after.bodyReflectivities()).isSameAs(before.bodyReflectivities());
        assertThat(after.skybox()).isSameAs(before.skybox());
        assertThat(after.skyboxDimensions()).isSameAs(before.skyboxDimensions());
        assertThat(after.shadowDisc()).isSameAs(before.shadowDisc());
        assertThat(after.pixelOffsets()).isSameAs(before.pixelOffsets());
        assertThat(after.hierarchy()).isSameAs(before.hierarchy());
    }

    @Test
    void snapshotStaysAsItWas() {
        FrameInput before = world.snapshot();
        float[] camera = before.camera().clone();
        int[] dimensions = before.dimensions().clone();
        float[] properties = before.rayTracingProperties().clone();
        world.setCamera(Camera.of(new Vector3(-1, -2, -3), 1, 2, 30));
        world.setSettings(world.settings().withBounces(1).withSize(8, 9));
        world.snapshot();
        assertThat(before.camera()).isEqualTo(camera);
        assertThat(before.dimensions()).isEqualTo(dimensions);
        assertThat(before.rayTracingProperties()).isEqualTo(properties);
    }

    @Test
    void tablesFollowTheirCounts() {
        world.setSettings(world.settings().withShadows(9).withSamplesPerPixel(4));
        assertThat(world.snapshot().shadowDisc()).isEqualTo(SunflowerDisc.points(9));
        assertThat(world.snapshot().pixelOffsets()).isEqualTo(PixelOffsets.places(4));
    }
}
