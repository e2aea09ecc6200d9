package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.gltf.AnimatedGltf;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.sky.Skybox;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Meshes at times of the animations of their files. */
class PosedMeshesTest {
    private static final Skybox SKY = new Skybox(1, 1, new float[] {1, 1, 1});
    private static final MeshAnimation MOVE = MeshAnimation.of("move");

    @TempDir
    Path folder;

    private Mesh mesh;

    @BeforeEach
    void writeAFile() throws IOException {
        AnimatedGltf gltf = new AnimatedGltf();
        int target = gltf.accessor("VEC3", 0, 0, 0, 8, 0, 0, 0, 0, 0);
        int times = gltf.accessor("SCALAR", 0, 2);
        int weights = gltf.accessor("SCALAR", 0, 1);
        String text = gltf.primitive(",\"targets\":[{\"POSITION\":" + target + "}]")
                .channel(0, "weights", "LINEAR", times, weights)
                .text("");
        Files.writeString(folder.resolve("a.gltf"), text);
        mesh = Mesh.of(folder.resolve("a.gltf")).withAnimation(MOVE);
    }

    private static Scene scene(Mesh... meshes) {
        return Scene.under(Path.of("sky.hdr")).withMeshes(List.of(meshes));
    }

    private static SceneMeshes read(Scene scene) {
        return SceneMeshes.read(scene, _ -> {});
    }

    private static String digest(FrameInput input) {
        return new FrameDigest().of(input, "");
    }

    /** The largest x of the corners that the first mesh's triangles have. */
    private static float right(FrameInput input) {
        float[] floats = input.bodies().floats();
        int instance = Instance.at(0, input.bodies().instances(), floats);
        return input.bodies().meshes()[Instance.triangles(floats, instance) + 6];
    }

    @Test
    void aFrameIsTheSameWhateverWasShownBefore() {
        Scene scene = scene(mesh);
        SceneMeshes meshes = read(scene);
        World world = World.of(scene, SceneImages.of(SKY), meshes);
        Scene later = Animation.at(scene, 0.5);

        world.show(Animation.at(scene, 1.5));
        String other = digest(world.snapshot());
        world.show(later);

        assertThat(right(world.snapshot())).isEqualTo(3);
        assertThat(digest(world.snapshot()))
                .isEqualTo(digest(World.of(later, SceneImages.of(SKY), meshes).snapshot()))
                .isNotEqualTo(other);
    }

    @Test
    void arraysStayTheSameWhereTheTimeOfTheAnimationDoes() {
        Scene scene = Animation.at(scene(mesh), 0.5);
        World world = World.of(scene, SceneImages.of(SKY), read(scene));
        FrameInput before = world.snapshot();

        world.show(scene.withCamera(scene.camera().withYawDegrees(3)));

        FrameInput now = world.snapshot();
        assertThat(now.bodies().meshes()).isSameAs(before.bodies().meshes());
        assertThat(now.bodies().looks()).isSameAs(before.bodies().looks());
        world.show(Animation.at(scene(mesh), 0.75));
        assertThat(world.snapshot().images()).isSameAs(before.images());
        assertThat(world.snapshot().bodies().looks()).isSameAs(before.bodies().looks());
    }

    @Test
    void boxesHoldTheTrianglesAfterThem() {
        Scene scene = scene(mesh);
        World world = World.of(scene, SceneImages.of(SKY), read(scene));

        world.show(Animation.at(scene, 1));

        float[] meshes = world.snapshot().bodies().meshes();
        assertThat(meshes[Layout.NODE_CENTER] + meshes[Layout.NODE_HALF]).isBetween(5f, 5.001f);
        assertThat(meshes[Layout.NODE_CENTER] - meshes[Layout.NODE_HALF]).isBetween(-0.001f, 0f);
    }

    @Test
    void meshesOfOneFileAreAtTheirOwnTimes() {
        Mesh still = mesh.withAnimation(MeshAnimation.NONE);
        Mesh ahead = mesh.withAnimation(MOVE.withStart(1));
        Scene scene = scene(still, mesh, ahead);
        World world = World.of(scene, SceneImages.of(SKY), read(scene));

        world.show(Animation.at(scene, 0.5));

        SceneMeshes meshes = world.meshes();
        List<Mesh> now = world.scene().meshes();
        assertThat(now.stream().map(one -> meshes.file(one).bounds().largest().x()))
                .containsExactly(1.0, 3.0, 7.0);
        assertThat(meshes.farPoints(now.get(2))).extracting(Vector3::x).contains(7.0);
    }

    @Test
    void aFilmIsAsLongAsOneTurn() {
        Scene scene = scene(mesh);
        SceneMeshes meshes = read(scene);

        assertThat(Animation.frames(scene, meshes, 10)).isEqualTo(20);
        assertThat(Animation.frames(with(MOVE.withSpeed(-4)), meshes, 10)).isEqualTo(5);
        assertThat(Animation.frames(with(MOVE.withStart(0.5).withLoop(false)), meshes, 10))
                .isEqualTo(16);
        assertThat(Animation.isIn(with(MOVE.withSpeed(0)))).isFalse();
    }

    private Scene with(MeshAnimation animation) {
        return scene(mesh.withAnimation(animation));
    }

    @Test
    void anUnknownAnimationIsAnError() {
        assertThatThrownBy(() -> read(with(MeshAnimation.of("Walk"))))
                .isInstanceOf(MeshException.class)
                .hasMessage("meshes[0].animation: the file has no animation 'Walk'; expected one of: 0 ('move')");
        assertThat(read(with(MeshAnimation.of("0"))).clipSeconds(mesh)).isEqualTo(2);
    }
}
