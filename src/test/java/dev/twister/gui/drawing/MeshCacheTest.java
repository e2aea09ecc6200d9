package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.WindowScenes;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.oracle.MeshShapes;
import dev.twister.scene.Geometry;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.world.SceneMeshes;
import dev.twister.world.SceneMeshes.Source;
import java.nio.file.Path;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;

class MeshCacheTest {
    private static final Mesh CUBE = Mesh.of(Path.of("cube.obj"));
    private static final Mesh BALL = Mesh.of(Path.of("ball.obj"));
    private static final Mesh BROKEN = Mesh.of(Path.of("broken.obj"));
    private static final long LIMIT_SECONDS = 300;

    private final Queue<Geometry> read = new ConcurrentLinkedQueue<>();
    private final CountDownLatch go = new CountDownLatch(1);
    private final MeshCache cache = new MeshCache(this::read);

    private MeshFile read(Source source) {
        read.add(source.geometry());
        if (source.equals(Source.of(BROKEN))) {
            throw new MeshException("broken.obj: holds no triangles");
        }
        if (source.equals(Source.of(BALL))) {
            await(() -> go.getCount() == 0);
        }
        return MeshShapes.file(MeshShapes.cube());
    }

    private static void await(BooleanSupplier condition) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(LIMIT_SECONDS);
        while (!condition.getAsBoolean()) {
            assertThat(System.nanoTime()).isLessThan(end);
            Thread.onSpinWait();
        }
    }

    private static Scene of(Mesh... meshes) {
        return WindowScenes.tiny().withMeshes(List.of(meshes));
    }

    private SceneMeshes awaited(Scene scene, long document) {
        long edition = cache.edition();
        SceneMeshes first = cache.of(scene, document);
        await(() -> cache.edition() != edition);
        assertThat(first.holds(scene.meshes().getFirst())).isFalse();
        return cache.of(scene, document);
    }

    @Test
    void aFileIsReadOnceForTwoMeshesAndLeavesThoseThatAreThere() {
        SceneMeshes meshes = awaited(of(CUBE, CUBE.withScale(2)), 0);
        assertThat(meshes.holds(CUBE.withScale(3))).isTrue();
        assertThat(read).containsExactly(CUBE.geometry());
        go.countDown();

        SceneMeshes more = awaited(of(BALL, CUBE), 0);
        assertThat(more.holds(CUBE)).isTrue();
        assertThat(more.holds(BALL)).isTrue();
        assertThat(read).containsExactly(CUBE.geometry(), BALL.geometry());
        assertThat(cache.progress()).isEmpty();
        // Undo brings a deleted one back at once.
        assertThat(cache.of(of(CUBE), 0)).isSameAs(more);
    }

    @Test
    void shapesAreThereAtOnce() {
        Mesh box = Mesh.of(Shape.of(Shape.Kind.BOX, 1));

        assertThat(cache.of(of(box), 0).holds(box)).isTrue();
        assertThat(cache.progress()).isEmpty();
    }

    @Test
    void whatCannotBeReadIsToldAndTheRestIsShown() {
        Scene scene = of(BROKEN, CUBE);
        SceneMeshes meshes = awaited(scene, 0);
        assertThat(meshes.holds(CUBE)).isTrue();
        assertThat(meshes.holds(BROKEN)).isFalse();
        assertThat(cache.complaint(scene)).contains("broken.obj: holds no triangles");
        assertThat(cache.complaint(of(CUBE))).isEmpty();
        assertThat(meshes.shown(scene).meshes()).containsExactly(CUBE);
    }

    @Test
    void whatIsCanceledIsReadAgainWithTheNextDocument() {
        Scene scene = of(BALL, CUBE);
        cache.of(scene, 0);
        await(() -> !read.isEmpty());
        assertThat(cache.progress()).contains("ball.obj (1 of 2)");
        cache.cancel();
        assertThat(cache.progress()).isEmpty();
        assertThat(cache.complaint(scene))
                .hasValueSatisfying(why -> assertThat(why).startsWith("ball.obj: reading was canceled"));
        cache.of(scene, 0);
        assertThat(cache.progress()).isEmpty();
        go.countDown();
        assertThat(awaited(scene, 1).holds(BALL)).isTrue();
        assertThat(cache.complaint(scene)).isEmpty();
        assertThat(cache.of(scene, 0)).isSameAs(SceneMeshes.NONE);
    }

    @Test
    void aFileThatWasReadForTheSceneIsNotReadAgain() {
        cache.keep(CUBE, MeshShapes.file(MeshShapes.cube()));
        assertThat(awaited(of(CUBE), 0).holds(CUBE)).isTrue();
        assertThat(read).isEmpty();
        awaited(of(CUBE), 1);
        assertThat(read).containsExactly(CUBE.geometry());
    }
}
