package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import dev.twister.scene.Camera;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.ToneMap;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.material.Attenuation;
import dev.twister.scene.material.Emission;
import dev.twister.sky.Skybox;
import dev.twister.world.hierarchy.SphereHierarchy;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WorldTest {
    private final World world = Worlds.world();

    @Test
    void bodiesStandInTheirPlaces() {
        FrameInput input = world.snapshot();
        assertThat(input.bodyCount()).isEqualTo(4);
        assertThat(places(input)).containsExactly(4, 5, 6, 7, 0, 12, 0, 11, 20, 21, 22, 23, 28, 29, 30, 31);
        assertThat(looks(input, Layout.LIGHT)).startsWith(8, 9, 10, 0, 0, 0, 0, 0);
        assertThat(looks(input, Layout.PLANE)).startsWith(0.13f, 0.14f, 0.15f, 19, 0, 0, 0, 0);
        assertThat(looks(input, Layout.FIRST_SPHERE)).startsWith(0.24f, 0.25f, 0.26f, 27, 0, 0, 0, 0);
        assertThat(looks(input, Layout.FIRST_SPHERE + 1)).startsWith(0.32f, 0.33f, 0.34f, 35, 0, 0, 0, 0);
    }

    @Test
    void materialsStandInTheirPlaces() {
        Path file = Path.of("texture.png");
        Skybox texture = new Skybox(1, 1, new float[] {90, 91, 92});
        Material material = Material.DEFAULT
                .withColor(new Rgb(0.1, 0.2, 0.3))
                .withReflectivity(40)
                .withRoughness(0.41)
                .withTransmission(0.42)
                .withIor(1.43)
                .withTexture(file)
                .withMetallic(0.44)
                .withEmission(new Emission(new Rgb(2, 4, 6), 0.5, false, LightGroup.NONE))
                .withAttenuation(new Attenuation(new Rgb(Math.exp(-1), Math.exp(-2), 1), Optional.of(2.0)));
        Scene scene = Worlds.scene();
        Sphere sphere = scene.spheres().getFirst().withMaterial(material);
        FrameInput input = World.of(
                        scene.withSpheres(List.of(sphere)), new SceneImages(Worlds.SKY, Map.of(file, texture)))
                .snapshot();
        assertThat(looks(input, Layout.FIRST_SPHERE))
                .containsExactly(
                        0.1f, 0.2f, 0.3f, 40, 0.41f, 0.42f, 1.43f, 1, 0.44f, -1, 1, 2, 3, 0, 1, 0.5f, 1, 0, 0, 0, 40, 0,
                        0, 0, 0, 0, 0, 0, 0, 0, 0);
        assertThat(input.images())
                .startsWith(70, 71, 72, 73, 74, 75, 0)
                .hasSize(Layout.ALIGNMENT + 3)
                .endsWith(90, 91, 92);
        assertThat(Arrays.copyOfRange(
                        input.bodies().looks(),
                        input.bodies().textures(),
                        input.bodies().looks().length))
                .startsWith(1, 1, 1)
                .hasSize(Layout.MAPS_STRIDE + 1);
    }

    private static float[] places(FrameInput input) {
        return Arrays.copyOf(input.bodies().floats(), input.bodies().spheres());
    }

    private static float[] looks(FrameInput input, int body) {
        int first = Layout.LOOK_STRIDE * body;
        return Arrays.copyOfRange(input.bodies().looks(), first, first + Layout.LOOK_STRIDE);
    }

    @Test
    void settingsStandInTheirPlaces() {
        world.setSettings(world.settings().withTone(3, ToneMap.ACES, true));
        FrameInput input = world.snapshot();
        float[] frame = input.view().frame();
        assertThat(Arrays.copyOfRange(frame, Layout.CAMERA_LENGTH, Layout.WIDTH))
                .containsExactly(5, 6, 3, 8, Tone.ACES, 1, 0.36f, 0.16f, 0.17f, 0.18f, 0.75f, 37, 2, 1);
        assertThat(Arrays.copyOfRange(frame, Layout.FIRST_MESH, Layout.DISC))
                .containsExactly(
                        Layout.NO_MESHES,
                        input.shadowRoot(),
                        input.bodies().floats().length,
                        input.bodies().looks().length - 1,
                        10,
                        0,
                        0,
                        0,
                        0,
                        1,
                        input.bodies().looks().length - 1,
                        input.shadowRoot(),
                        0,
                        0,
                        0,
                        0,
                        0,
                        -1,
                        -1,
                        0,
                        Layout.DISC + 2 * 5);
    }

    @ParameterizedTest
    @CsvSource({"CLAMP, 0", "REINHARD, 1", "ACES, 2"})
    void toneMapsHaveTheKernelsNumbers(ToneMap toneMap, float number) {
        world.setSettings(world.settings().withTone(0, toneMap, false));
        assertThat(world.snapshot().view().frame()[Layout.TONE_MAP]).isEqualTo(number);
    }

    @Test
    void movedBodiesAreInALaterSnapshotOnly() {
        FrameInput before = world.snapshot();
        float[] moved = Positions.of(before);
        moved[6] = 99;
        world.setBodyPositions(moved, 3);
        assertThat(Positions.of(before)[6]).isEqualTo(20);
        assertThat(before.bodyCount()).isEqualTo(4);
        assertThat(Positions.of(world.snapshot())).isEqualTo(moved);
        assertThat(world.snapshot().bodyCount()).isEqualTo(3);
    }

    @Test
    void hierarchyFollowsTheBodies() {
        FrameInput before = world.snapshot();
        assertThat(world.snapshot().bodies().floats()).isSameAs(before.bodies().floats());
        float[] moved = Positions.of(before);
        moved[6] = 99;
        world.setBodyPositions(moved, 3);
        assertThat(world.snapshot().bodies().floats())
                .isEqualTo(SphereHierarchy.of(places(world.snapshot()), 3))
                .hasSameSizeAs(before.bodies().floats())
                .isNotEqualTo(before.bodies().floats());
    }

    @Test
    void movedBodiesKeepLooksMeshesAndImages() {
        FrameInput before = world.snapshot();
        world.setBodyPositions(Positions.of(before), 3);
        FrameInput after = world.snapshot();
        assertThat(after.bodies().floats()).isNotSameAs(before.bodies().floats());
        assertThat(after.bodies().looks()).isSameAs(before.bodies().looks());
        assertThat(after.bodies().meshes()).isSameAs(before.bodies().meshes());
        assertThat(after.images()).isSameAs(before.images());
    }

    @Test
    void refusesPositionsThatDoNotFit() {
        assertThatThrownBy(() -> world.setBodyPositions(new float[9], 3))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("9 coordinates for 4 bodies");
        float[] positions = Positions.of(world.snapshot());
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
        assertThat(input.bodyCount()).isEqualTo(4);
        assertThat(places(input)).hasSize(36).endsWith(0.1f);
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
        assertThat(input.images()).isSameAs(Worlds.SKY.radiance());
    }

    @Test
    void pictureIsDrawnWhole() {
        assertThat(Arrays.copyOfRange(world.snapshot().view().frame(), Layout.WIDTH, Layout.FIRST_MESH))
                .containsExactly(40, 30, 0, 30, 4);
    }

    @Test
    void arraysThatStillHoldAreTheSameOnes() {
        FrameInput before = world.snapshot();
        world.setCamera(Camera.of(new Vector3(-1, -2, -3), 1, 2, 30));
        world.setSettings(world.settings().withBounces(1).withSize(8, 9));
        FrameInput after = world.snapshot();
        assertThat(after.bodies().floats()).isSameAs(before.bodies().floats());
        assertThat(after.bodies().looks()).isSameAs(before.bodies().looks());
        assertThat(after.bodies().meshes()).isSameAs(before.bodies().meshes());
        assertThat(after.images()).isSameAs(before.images());
    }

    @Test
    void snapshotStaysAsItWas() {
        FrameInput before = world.snapshot();
        float[] frame = before.view().frame().clone();
        float[] floats = before.bodies().floats().clone();
        world.setCamera(Camera.of(new Vector3(-1, -2, -3), 1, 2, 30));
        world.setSettings(world.settings().withBounces(1).withSize(8, 9));
        world.setBodyPositions(new float[12], 4);
        world.snapshot();
        assertThat(before.view().frame()).isEqualTo(frame);
        assertThat(before.bodies().floats()).isEqualTo(floats);
    }

    @Test
    void tablesFollowTheirCounts() {
        world.setSettings(world.settings().withShadowSamples(9).withSamplesPerPixel(4));
        float[] frame = world.snapshot().view().frame();
        int samples = world.snapshot().view().samplePlace(0);
        assertThat(Arrays.copyOfRange(frame, Layout.DISC, samples)).isEqualTo(SunflowerDisc.points(9));
        assertThat(Arrays.copyOfRange(frame, samples, frame.length)).isEqualTo(PixelSamples.of(4));
    }
}
