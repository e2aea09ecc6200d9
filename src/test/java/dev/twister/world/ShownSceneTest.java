package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.FullScene;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneChanges;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.TexturePlaces;
import dev.twister.scene.generate.SceneGenerator;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.sky.TextureImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SequencedMap;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What a world makes of an edited scene. */
class ShownSceneTest {
    private static final SequencedMap<String, Scene> CHANGES = SceneChanges.of(FullScene.SCENE);
    private static final Scene CROWD = SceneGenerator.spheres(5000, 1, Path.of("none.hdr"));

    private final World crowd = World.of(CROWD, Worlds.SKY);
    private final FrameInput before = crowd.snapshot();

    static Set<String> places() {
        return CHANGES.keySet();
    }

    @ParameterizedTest
    @MethodSource("places")
    void isWhatANewWorldMakesOfIt(String place) {
        Scene scene = FullScene.SCENE;
        Scene changed = CHANGES.get(place);
        SceneMeshes meshes = SceneMeshes.of(scene, FullScene.MESHES);
        SceneMeshes changedMeshes = meshes.changedTo(changed.meshes(), FullScene.MESHES);
        World world = World.of(scene, images(scene), meshes);
        world.snapshot();

        world.show(changed, images(changed), changedMeshes);

        assertThat(world.snapshot())
                .usingRecursiveComparison()
                .withEqualsForType(Arrays::equals, float[].class)
                .withEqualsForType(Arrays::equals, int[].class)
                .isEqualTo(World.of(changed, images(changed), changedMeshes).snapshot());
    }

    private static SceneImages images(Scene scene) {
        Map<Path, TextureImage> textures = new HashMap<>();
        TexturePlaces.of(scene).keySet().forEach(file -> textures.put(file, texture(file)));
        return new SceneImages(Worlds.SKY, textures);
    }

    private static Skybox texture(Path file) {
        float value = file.toString().length();
        return new Skybox(1, 1, new float[] {value, value, value});
    }

    @Test
    void aMovedLightKeepsTheHierarchyAndTheLooks() {
        crowd.show(CROWD.withLights(Lights.of(CROWD.lights().first().withPosition(new Vector3(1, 2, 3)))));

        FrameInput after = crowd.snapshot();
        assertThat(after.bodies().hasHierarchyOf(before.bodies())).isTrue();
        assertThat(after.bodies().looks()).isSameAs(before.bodies().looks());
        assertThat(after.bodies().centerInScene(0)).isEqualTo(new Vector3(1, 2, 3));
    }

    @Test
    void anotherNumberOfLightsIsWhatANewWorldMakesOfIt() {
        Light lamp = Light.of(new Vector3(3, 4, 5), 0.5, new Rgb(1, 0.5, 0));
        Scene more = CROWD.withLights(CROWD.lights().with(List.of(lamp, lamp)));

        crowd.show(more);
        FrameInput shown = crowd.snapshot();
        FrameInput made = World.of(more, Worlds.SKY).snapshot();

        assertThat(shown.bodies().floats()).isEqualTo(made.bodies().floats());
        assertThat(shown.bodies().looks()).isEqualTo(made.bodies().looks());
        assertThat(shown.view().frame()).isEqualTo(made.view().frame());
        assertThat(shown.light(2)).isEqualTo(5003);
    }

    @Test
    void ambientAndSkyKeepAllArraysOfBodies() {
        crowd.show(CROWD.withShading(new Shading(0.9)).withSky(CROWD.sky().withStrength(3)));

        assertThat(crowd.snapshot().bodies().floats()).isSameAs(before.bodies().floats());
        assertThat(crowd.snapshot().bodies().looks()).isSameAs(before.bodies().looks());
    }

    @Test
    void anotherMaterialKeepsThePlaces() {
        List<Sphere> spheres = new ArrayList<>(CROWD.spheres());
        spheres.set(7, spheres.get(7).withMaterial(Material.DEFAULT));

        crowd.show(CROWD.withSpheres(spheres));

        assertThat(crowd.snapshot().bodies().floats()).isSameAs(before.bodies().floats());
        assertThat(crowd.snapshot().bodies().looks())
                .isNotSameAs(before.bodies().looks());
    }

    @Test
    void aMovedSphereIsInTheHierarchy() {
        List<Sphere> spheres = new ArrayList<>(CROWD.spheres());
        spheres.set(7, spheres.get(7).withPosition(new Vector3(0, 50, 0)));
        Scene edited = CROWD.withSpheres(spheres);

        crowd.show(edited);

        assertThat(crowd.snapshot().bodies().floats())
                .isEqualTo(World.of(edited, Worlds.SKY).snapshot().bodies().floats());
    }

    @Test
    void movedBodiesStayWhereTheyAreUntilTheSceneHasOthers() {
        float[] positions = Positions.of(before);
        positions[6] += 1;
        crowd.setBodyPositions(positions, before.bodyCount());

        crowd.show(CROWD.withLights(Lights.of(CROWD.lights().first().withPosition(new Vector3(1, 2, 3)))));
        assertThat(crowd.isMoved()).isTrue();
        assertThat(crowd.snapshot().bodies().center(2, 0)).isEqualTo(positions[6]);

        crowd.resetBodies();
        assertThat(crowd.isMoved()).isFalse();
        assertThat(crowd.snapshot().bodies().center(2, 0))
                .isEqualTo(before.bodies().center(2, 0));
    }
}
