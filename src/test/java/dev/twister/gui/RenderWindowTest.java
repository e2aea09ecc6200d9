package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.denoise.FakeDenoiser;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.controls.Command;
import dev.twister.gui.rendering.RenderFormat;
import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrReader;
import dev.twister.image.Frame;
import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Scene;
import dev.twister.world.FrameInput;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.RadioButton;
import javafx.scene.control.TextField;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The window that renders to files, by hand. */
class RenderWindowTest {
    private static final int WIDTH = 37;
    private static final int HEIGHT = 21;

    @TempDir
    private Path folder;

    @Test
    void rendersAPictureBesideTheWindow() throws IOException {
        Path file = folder.resolve("picture.png");
        try (WindowDriver driver = open()) {
            driver.files.choose(file);

            press(driver, "render-start");
            driver.await(() -> driver.notice().startsWith("Rendered"));

            assertThat(driver.files.suggested().orElseThrow()).hasFileName("test.png");
            assertThat(text("render-state")).isEqualTo("Rendered " + file);
            assertThat(driver.notice()).isEqualTo("Rendered " + file);
            BufferedImage image = ImageIO.read(file.toFile());
            assertThat(image.getWidth()).isEqualTo(WIDTH);
            assertThat(image.getHeight()).isEqualTo(HEIGHT);
        }
    }

    @Tag("slow")
    @Test
    void rendersAFilmOfTheKeyframesWithAllItsFrames() {
        Scene scene = WindowScenes.tiny().withSpheres(List.of());
        Camera camera = scene.camera();
        Scene moving = scene.withCamera(camera.withKeyframes(
                List.of(CameraKeyframe.of(0, camera), CameraKeyframe.of(2, camera.withYawDegrees(30)))));
        try (WindowDriver driver = open(moving, JvmEngines.parallel())) {
            driver.files.choose(folder.resolve("film-####.png"));
            choose(driver, "render-film");
            type(driver, "render-frames-per-second", "4");
            driver.run(() -> formats().setValue(RenderFormat.PNG_FRAMES));
            assertThat(text("render-length")).isEqualTo("9 frames, 2.25 s");
            driver.pulse();
            assertThat(bottom("render-motion")).isLessThan(bottom("render-frames-per-second"));
            assertThat(bottom("render-frames-per-second")).isLessThan(bottom("render-size"));

            press(driver, "render-start");
            driver.await(() -> driver.notice().startsWith("Rendered"));

            assertThat(folder.toFile().list()).hasSize(9).contains("film-0000.png", "film-0008.png");
            assertThat(driver.notice()).endsWith("film-0000.png, 9 frames");

            press(driver, "render-start");
            driver.answer(driver.awaitDialog("frames-question"), "Cancel");
        }
    }

    @Tag("slow")
    @Test
    void removesTheNoiseOnDemand() throws IOException {
        System.setProperty(FakeDenoiser.PROPERTY, "true");
        Path noisy = folder.resolve("noisy.png");
        Path clean = folder.resolve("clean.png");
        try (WindowDriver driver = open()) {
            driver.await(() -> !find("render-denoise", CheckBox.class).isDisabled());
            driver.files.choose(noisy);
            press(driver, "render-start");
            driver.await(() -> driver.notice().equals("Rendered " + noisy));
            driver.run(() -> find("render-denoise", CheckBox.class).fire());
            driver.files.choose(clean);
            press(driver, "render-start");
            driver.await(() -> driver.notice().equals("Rendered " + clean));
        } finally {
            System.clearProperty(FakeDenoiser.PROPERTY);
        }

        assertThat(Files.readAllBytes(clean)).isNotEqualTo(Files.readAllBytes(noisy));
    }

    @Tag("slow")
    @Test
    void writesAlphaAndTheLightOfGroupsUpToANoise() throws IOException {
        Path file = folder.resolve("layers.exr");
        try (WindowDriver driver = open()) {
            driver.files.choose(file);
            assertThat(find("render-light-layers", CheckBox.class).isDisabled()).isTrue();
            driver.run(() -> formats().setValue(RenderFormat.EXR));
            driver.run(() -> find("render-light-layers", CheckBox.class).fire());
            driver.run(() -> find("render-transparent", CheckBox.class).fire());
            driver.run(() ->
                    find("render-noise", ComboBox.class).getSelectionModel().select(1));
            type(driver, "render-samples-per-pixel", "64");
            driver.await(() -> text("render-estimate").startsWith("at most 64 samples per pixel"));

            type(driver, "render-samples-per-pixel", "4");
            assertThat(text("render-state"))
                    .isEqualTo("Samples per pixel is 4, but to stop at a noise, at least 8 are needed");
            type(driver, "render-samples-per-pixel", "64");
            press(driver, "render-start");
            driver.await(() -> driver.notice().equals("Rendered " + file));
        }

        assertThat(ExrReader.read(file).channels())
                .extracting(ExrChannel::name)
                .contains("R", "A", "light-lights.R", "light-sky.R", "guide-albedo.R", "samples.Y");
    }

    @Test
    void saysWhatKeepsItFromRendering() {
        try (WindowDriver driver = open(WindowScenes.tiny().withSpheres(List.of()), JvmEngines.parallel())) {
            type(driver, "render-samples-per-pixel", "0");
            assertThat(text("render-state"))
                    .isEqualTo("Samples per pixel is '0', but must be a whole number from 1 to 65536");
            assertThat(isDisabled("render-start")).isTrue();
            type(driver, "render-samples-per-pixel", "2");
            assertThat(text("render-state")).isEmpty();
            assertThat(isDisabled("render-start")).isFalse();

            choose(driver, "render-film");
            assertThat(text("render-state")).startsWith("Nothing moves");
            assertThat(isDisabled("render-start")).isTrue();
        }
    }

    @Tag("slow")
    @Test
    void neverReplacesAFileOfTheScene() {
        try (WindowDriver driver = open()) {
            Path sky = WindowDriver.call(driver.studio::scene).sky().file();
            driver.files.choose(sky);

            press(driver, "render-start");

            driver.answer(driver.awaitDialog("complaint"), "OK");
            assertThat(Files.exists(sky)).isTrue();
        }
    }

    @Test
    void cancelingLeavesNoFileAndClosingAsks() {
        CountDownLatch mayDraw = new CountDownLatch(1);
        try (WindowDriver driver = open(WindowScenes.tiny(), slowAtRendering(mayDraw))) {
            driver.files.choose(folder.resolve("picture.png"));
            press(driver, "render-start");

            driver.run(() -> driver.stage.fireEvent(new WindowEvent(driver.stage, WindowEvent.WINDOW_CLOSE_REQUEST)));
            driver.answer(driver.awaitDialog("render-question"), "Keep rendering");
            assertThat(WindowDriver.call(driver.stage::isShowing)).isTrue();

            press(driver, "render-cancel");
            mayDraw.countDown();
            driver.awaitNotice("Render canceled");
            assertThat(folder).isEmptyDirectory();
            assertThat(isDisabled("render-start")).isFalse();
        } finally {
            mayDraw.countDown();
        }
    }

    @Tag("slow")
    @Test
    void aSecondRenderWaitsAndTheStatusLineShowsTheFirst() {
        CountDownLatch mayDraw = new CountDownLatch(1);
        try (WindowDriver driver = open(WindowScenes.tiny(), slowAtRendering(mayDraw))) {
            driver.files.choose(folder.resolve("first.png"));
            press(driver, "render-start");
            driver.files.choose(folder.resolve("second.png"));
            press(driver, "render-start");
            assertThat(WindowDriver.call(() -> find("render-waiting", Parent.class)
                            .getChildrenUnmodifiable()
                            .size()))
                    .isEqualTo(1);
            press(driver, "render-close");
            driver.await(() -> driver.text("rendering").startsWith("first.png: "));
            assertThat(driver.text("rendering")).endsWith(" · 1 waiting");
            mayDraw.countDown();
            driver.await(() ->
                    driver.notice().startsWith("Rendered") && driver.notice().endsWith("second.png"));
            assertThat(folder.toFile().list()).containsExactlyInAnyOrder("first.png", "second.png");
            driver.await(() ->
                    !driver.find("#cancel-rendering", Node.class).getParent().isVisible());
        } finally {
            mayDraw.countDown();
        }
    }

    @Tag("slow")
    @Test
    void tellsHowMuchItIsBeforeItStarts() {
        try (WindowDriver driver = open()) {
            type(driver, "render-samples-per-pixel", "1000");
            driver.await(() -> text("render-estimate").startsWith("1,000 samples per pixel, about "));
        }
    }

    @Tag("slow")
    @Test
    void closingTheWindowMayCancelTheRender() {
        CountDownLatch mayDraw = new CountDownLatch(1);
        try (WindowDriver driver = open(WindowScenes.tiny(), slowAtRendering(mayDraw))) {
            driver.files.choose(folder.resolve("picture.png"));
            press(driver, "render-start");

            driver.run(() -> driver.stage.fireEvent(new WindowEvent(driver.stage, WindowEvent.WINDOW_CLOSE_REQUEST)));
            driver.answer(driver.awaitDialog("render-question"), "Cancel render");

            driver.await(() -> !driver.stage.isShowing());
            mayDraw.countDown();
        } finally {
            mayDraw.countDown();
        }
        assertThat(folder).isEmptyDirectory();
    }

    /** Draws the window's pictures, and waits before it draws the job's. */
    private static EngineOffer slowAtRendering(CountDownLatch mayDraw) {
        return EngineOffer.working("slow", "a test", "waits", () -> {
            Engine engine = JvmEngines.parallel().opener().get();
            return new Engine() {
                @Override
                public String id() {
                    return "slow";
                }

                @Override
                public String device() {
                    return "a test";
                }

                @Override
                public void render(FrameInput input, Frame frame) {
                    if (input.width() == WIDTH) {
                        try {
                            mayDraw.await();
                        } catch (InterruptedException problem) {
                            throw new AssertionError(problem);
                        }
                    }
                    engine.render(input, frame);
                }

                @Override
                public void close() {
                    engine.close();
                }
            };
        });
    }

    private static WindowDriver open() {
        return open(WindowScenes.tiny(), JvmEngines.parallel());
    }

    /** A window with the one that renders, which has a small picture in it. */
    private static WindowDriver open(Scene scene, EngineOffer engine) {
        WindowDriver driver = WindowDriver.open(scene, engine);
        driver.type(Command.RENDER.keys());
        type(driver, "render-width", Integer.toString(WIDTH));
        type(driver, "render-height", Integer.toString(HEIGHT));
        type(driver, "render-samples-per-pixel", "1");
        return driver;
    }

    private static <T extends Node> T find(String id, Class<T> kind) {
        return Window.getWindows().stream()
                .map(window -> window.getScene().getRoot())
                .filter(root -> "render-page".equals(root.getId()))
                .map((Parent root) -> kind.cast(root.lookup("#" + id)))
                .findFirst()
                .orElseThrow();
    }

    @SuppressWarnings("unchecked")
    private static ComboBox<RenderFormat> formats() {
        return find("render-format", ComboBox.class);
    }

    private static void type(WindowDriver driver, String id, String text) {
        driver.run(() -> find(id, TextField.class).setText(text));
    }

    private static void choose(WindowDriver driver, String id) {
        driver.run(() -> find(id, RadioButton.class).setSelected(true));
    }

    private static void press(WindowDriver driver, String id) {
        driver.run(() -> find(id, Button.class).fire());
    }

    private static String text(String id) {
        return WindowDriver.call(() -> find(id, Label.class).getText());
    }

    /** Where a control ends in its window. */
    private static double bottom(String id) {
        return WindowDriver.call(() -> {
            Node node = find(id, Node.class);
            return node.localToScene(node.getLayoutBounds()).getMaxY();
        });
    }

    private static boolean isDisabled(String id) {
        return WindowDriver.call(() -> find(id, Button.class).isDisabled());
    }
}
