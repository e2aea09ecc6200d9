package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engines;
import dev.twister.gui.rendering.RenderJob;
import dev.twister.gui.rendering.WindowOrder;
import dev.twister.gui.rendering.WindowOrder.FilmMotion;
import dev.twister.gui.rendering.WindowOrder.FilmPlan;
import dev.twister.gui.rendering.WindowOrder.MovingScene;
import dev.twister.physics.Simulation;
import dev.twister.render.FrameRange;
import dev.twister.render.RenderOrder;
import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.format.SceneWriter;
import dev.twister.world.Animation;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.StageOrView;
import dev.twister.world.World;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files that the window renders: those of {@code twister render}, byte by byte. */
class WindowFilesTest {
    private static final String ENGINE = "sequential";
    private static final double RATE = 10;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"a.png", "a.hdr", "a.exr"})
    void pictures(String name) {
        Path file = render(scene("teaching"), StageOrView.BEAUTY, Optional.empty(), name);

        assertThat(file).hasSameBinaryContentAs(command(name));
    }

    @Test
    void picturesOfMeshes() {
        Path file = render(scene("knot"), StageOrView.BEAUTY, Optional.empty(), "a.png");

        assertThat(file).hasSameBinaryContentAs(command("a.png"));
    }

    @Test
    void stagesAndViews() {
        Scene scene = scene("teaching");
        Path stage = render(scene, StageOrView.DIFFUSE, Optional.empty(), "a.png");
        Path view = render(scene, StageOrView.DEPTH, Optional.empty(), "b.png");

        assertThat(stage).hasSameBinaryContentAs(command("a.png", "--stage", "diffuse"));
        assertThat(view).hasSameBinaryContentAs(command("b.png", "--view", "depth"));
    }

    @Test
    void filmsOfKeyframes() {
        Path file = film(withPath(scene("benchmark")), FilmMotion.KEYFRAMES, FrameRange.of(0, 20), "a.apng");

        // Without --frames the command renders the whole path, which is 2 s long.
        assertThat(file).hasSameBinaryContentAs(command("a.apng", "--fps", "10"));
    }

    @Test
    void framesOfPhysics() {
        Path file = film(scene("pour-1000"), FilmMotion.PHYSICS, FrameRange.of(5, 6), "f-####.png");

        Path same = command("f-####.png", "--physics", "--fps", "10", "--frames", "5-6");
        assertThat(file).hasFileName("f-0005.png");
        for (String name : List.of("f-0005.png", "f-0006.png")) {
            assertThat(file.resolveSibling(name)).hasSameBinaryContentAs(same.resolveSibling(name));
        }
    }

    @Test
    void framesOfBoth() {
        Path file = film(withPath(scene("teaching")), FilmMotion.KEYFRAMES_AND_PHYSICS, FrameRange.of(3, 3), "f.exr");

        Path same = command("f.exr", "--physics", "--fps", "10", "--frames", "3-3");
        assertThat(file).hasSameBinaryContentAs(same.resolveSibling("f-0003.exr"));
    }

    @Test
    void bodiesAreWhereTheyAreSeen() {
        Scene scene = scene("teaching");
        World world = world(scene);
        FrameInput seen;
        try (Simulation simulation = Simulation.of(scene, world.meshes())) {
            simulation.advance(0.5);
            simulation.place(world);
            seen = world.snapshot();
        }

        Path file = render(scene, StageOrView.BEAUTY, Optional.of(seen), "a.png");

        assertThat(file).hasSameBinaryContentAs(command("a.png", "--physics", "--start", "0.5"));
    }

    @Test
    void framesAreBlurred() {
        Scene scene = withPath(scene("teaching"));
        Scene blurred = scene.withRendering(scene.rendering().withShutter(0.5));
        Path file = film(blurred, FilmMotion.KEYFRAMES_AND_PHYSICS, FrameRange.of(3, 3), "f.exr");

        Path same = command("f.exr", "--physics", "--fps", "10", "--frames", "3-3");
        assertThat(file).hasSameBinaryContentAs(same.resolveSibling("f-0003.exr"));
    }

    @Test
    void picturesOfFilmsAreBlurred() {
        Scene scene = withPath(scene("teaching"));
        Scene blurred = scene.withRendering(scene.rendering().withShutter(0.5));
        MovingScene moving = new MovingScene(later -> Animation.at(blurred, 0.7 + later), RATE);
        Path file = render(WindowOrder.picture(
                moving, StageOrView.BEAUTY, Engines.offer(ENGINE), Optional.empty(), folder.resolve("a.png")));

        assertThat(file).hasSameBinaryContentAs(command("a.png", "--time", "0.7", "--fps", "10"));
        assertThat(command("b.png", "--time", "0.7", "--fps", "10", "--shutter", "0"))
                .satisfies(sharp -> assertThat(Files.mismatch(file, sharp)).isNotNegative());
    }

    private static Scene scene(String name) {
        Scene scene = SceneReader.read(Path.of("scenes", name + ".json").toAbsolutePath());
        return scene.withRendering(
                scene.rendering().withSize(32, 18).withShadowSamples(2).withSamplesPerPixel(3));
    }

    private static Scene withPath(Scene scene) {
        Camera camera = scene.camera();
        Vector3 from = camera.position();
        return scene.withCamera(camera.withKeyframes(List.of(
                CameraKeyframe.of(0, camera),
                CameraKeyframe.of(2, camera.withPosition(new Vector3(from.x() + 3, from.y(), from.z()))))));
    }

    private static World world(Scene scene) {
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        return World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
    }

    private Path film(Scene scene, FilmMotion motion, FrameRange frames, String name) {
        FilmPlan plan = new FilmPlan(motion, RATE, frames);
        return render(WindowOrder.film(scene, StageOrView.BEAUTY, Engines.offer(ENGINE), plan, folder.resolve(name)));
    }

    private Path render(Scene scene, StageOrView picture, Optional<FrameInput> seen, String name) {
        MovingScene still = new MovingScene(_ -> scene, RATE);
        return render(WindowOrder.picture(still, picture, Engines.offer(ENGINE), seen, folder.resolve(name)));
    }

    /** Renders as the window does, and saves the scene. */
    private Path render(RenderOrder order) {
        SceneWriter.write(order.scene(), folder.resolve("scene.json"));
        return RenderJob.start(order, () -> world(order.scene()), System::nanoTime)
                .result()
                .join();
    }

    /** Renders the saved scene as the command does, into a folder of its own. */
    private Path command(String name, String... options) {
        Path file = folder.resolve("command").resolve(name);
        assertThat(file.toFile().getParentFile().isDirectory()
                        || file.toFile().getParentFile().mkdir())
                .isTrue();
        List<String> arguments = new ArrayList<>(
                List.of("render", folder.resolve("scene.json").toString(), "-o", file.toString(), "--engine", ENGINE));
        arguments.addAll(List.of(options));
        Outcome outcome = Outcome.of(arguments.toArray(String[]::new));
        assertThat(outcome.err()).isEmpty();
        return file;
    }
}
