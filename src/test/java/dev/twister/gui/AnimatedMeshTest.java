package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.camera.FilmBar;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.panel.PanelRow;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.mesh.gltf.AnimatedGltf;
import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Easing;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Scene;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Slider;
import javafx.scene.layout.Pane;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Animations of meshes, played in the film bar. */
class AnimatedMeshTest {
    private static final int MESH = BodyNumber.ofMesh(0);
    private static WindowDriver driver;

    @TempDir
    private Path folder;

    @BeforeAll
    static void open() {
        driver = WindowDriver.openWithPanel();
    }

    @AfterAll
    static void close() {
        driver.close();
    }

    /** A triangle that goes 8 m to the right in 2 s. */
    @BeforeEach
    void show() throws IOException {
        AnimatedGltf gltf = new AnimatedGltf();
        int times = gltf.accessor("SCALAR", 0, 2);
        int places = gltf.accessor("VEC3", 0, 0, 0, 8, 0, 0);
        Files.writeString(
                folder.resolve("a.gltf"),
                gltf.channel(0, "translation", "LINEAR", times, places).text(""));
        Mesh mesh = Mesh.of(folder.resolve("a.gltf")).withAnimation(MeshAnimation.of("move"));
        Scene scene = WindowScenes.tiny().withMeshes(List.of(mesh));
        driver.run(() -> driver.studio.show(new OpenedScene(Path.of("test.json"), scene)));
        driver.await(() -> driver.studio.film().length() == 2);
    }

    private static double right() {
        DrawnPicture picture = driver.studio.pictureProperty().get().orElseThrow();
        Mesh mesh = picture.request().scene().meshes().getFirst();
        return picture.meshes().file(mesh).bounds().largest().x();
    }

    private static void awaitRight(double expected) {
        driver.await(() -> Math.abs(right() - expected) < 1e-6);
    }

    @Test
    void aTimeOfTheFilmShowsItAndTheSceneStaysAsItIs() {
        assertThat(driver.find("#film", FilmBar.class).isVisible()).isTrue();

        driver.run(() -> driver.studio.film().goTo(1));

        awaitRight(5);
        assertThat(WindowDriver.call(driver.studio::scene).meshes().getFirst().animation())
                .isEqualTo(MeshAnimation.of("move"));
        assertThat(WindowDriver.call(
                        () -> driver.studio.bodies().extent(MESH).half().x()))
                .isCloseTo(0.5, within(1e-3));
    }

    @Test
    void playingLoops() {
        driver.run(() -> {
            driver.studio.film().goTo(1.9);
            driver.studio.film().togglePlaying();
        });

        driver.await(() -> driver.studio.film().secondsProperty().get() < 1);

        assertThat(WindowDriver.call(driver.studio.film().playingProperty()::get))
                .isTrue();
        driver.run(driver.studio.film()::togglePlaying);
    }

    @Test
    void speedAndStartAreRowsAndTheTimeLineFollowsTheLength() {
        driver.run(() -> driver.studio.selection().select(List.of(MESH)));
        driver.await(() -> driver.find("#lane-meshes-0", Pane.class).isVisible());

        driver.run(() -> driver.studio.edit(
                "edit",
                scene -> scene.withMeshes(scene.meshes().stream()
                        .map(mesh -> mesh.withAnimation(mesh.animation().withSpeed(0.5)))
                        .toList())));

        driver.await(() -> driver.studio.film().length() == 4);
        driver.await(() -> driver.find("#film-slider", Slider.class).getMax() >= 4);
        assertThat(driver.find("#animation-speed", PanelRow.class).isVisible()).isTrue();
    }

    private static boolean has(String selector) {
        return driver.find(selector, Node.class) != null;
    }

    @Test
    @SuppressWarnings("unchecked") // a row's items are of one class
    void theAnimationIsAChoice() {
        driver.run(() -> driver.studio.selection().select(List.of(MESH)));
        driver.await(() -> has("#animation .combo-box"));
        ComboBox<String> box = driver.find("#animation .combo-box", ComboBox.class);
        assertThat(WindowDriver.call(box::getItems)).containsExactly("", "move");
        assertThat(WindowDriver.call(box::getValue)).isEqualTo("move");

        driver.run(() -> box.setValue(""));

        driver.await(() -> driver.studio.film().length() == 0);
        assertThat(WindowDriver.call(driver.studio::scene).meshes().getFirst().animation())
                .isEqualTo(MeshAnimation.NONE);
        driver.await(() -> !has("#animation-speed"));

        driver.run(() -> driver.find("#animation .combo-box", ComboBox.class).setValue("move"));

        driver.await(() -> driver.studio.film().length() == 2);
        driver.await(() -> has("#animation-speed"));
        assertThat(has("#animation-loop")).isTrue();
        driver.run(driver.studio::undo);
        driver.run(driver.studio::undo);
        assertThat(WindowDriver.call(driver.studio::scene).meshes().getFirst().animation())
                .isEqualTo(MeshAnimation.of("move"));
    }

    /** For motion blur. */
    @Test
    void theSceneAroundATimeMovesUnlessItWasEdited() {
        driver.run(() -> driver.studio.edit("edit", AnimatedMeshTest::withMovingCameraAndSphere));
        driver.run(() -> driver.studio.film().goTo(1));

        Scene before = played(-0.5);
        assertThat(before.meshes().getFirst().animation().start()).isEqualTo(0.5);
        assertThat(before.camera().position().x()).isCloseTo(1, within(1e-9));
        assertThat(before.spheres().getFirst().radius()).isCloseTo(1.5, within(1e-9));
        assertThat(played(0).camera().position().x()).isCloseTo(2, within(1e-9));

        driver.run(() -> driver.studio.moveCamera(camera -> camera.withYawDegrees(7)));
        driver.run(() -> driver.studio.edit(
                "edit",
                scene -> scene.withSpheres(List.of(scene.spheres().getFirst().withRadius(5)))));

        assertThat(played(-0.5).camera()).isEqualTo(played(0).camera());
        assertThat(played(-0.5).spheres()).isEqualTo(played(0).spheres());
        assertThat(played(-0.5).meshes().getFirst().animation().start()).isEqualTo(0.5);
    }

    private static Scene played(double later) {
        return WindowDriver.call(() -> driver.studio.film().played(driver.studio.scene(), later));
    }

    private static Scene withMovingCameraAndSphere(Scene scene) {
        Camera camera = scene.camera();
        Track growing = Track.of(
                TrackTarget.sphere(0), "radius", Keyframe.of(0, 1).withEasing(Easing.LINEAR), Keyframe.of(2, 3));
        return scene.withCamera(camera.withKeyframes(List.of(
                        CameraKeyframe.of(0, camera.withPosition(new Vector3(0, 1, 0))),
                        CameraKeyframe.of(2, camera.withPosition(new Vector3(4, 1, 0))))))
                .withTracks(List.of(growing));
    }
}
