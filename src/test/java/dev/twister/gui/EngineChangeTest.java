package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.RefinementGoal;
import dev.twister.gui.drawing.ResolutionMode;
import dev.twister.scene.Scene;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import javafx.scene.control.ComboBox;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Changes of what draws, how large, and what, while the window runs. */
class EngineChangeTest {
    @Test
    void enginesTakeTurns() {
        List<EngineOffer> jvm = Engines.offers().stream()
                .filter(offer -> List.of(JvmEngines.SEQUENTIAL, JvmEngines.PARALLEL, "vector")
                        .contains(offer.id()))
                .toList();
        try (WindowDriver driver = WindowDriver.open()) {
            for (int i = 0; i < 4; i++) {
                EngineOffer offer = jvm.get(i % jvm.size());
                driver.run(() -> driver.studio.chooseEngine(offer));
                DrawnPicture picture =
                        driver.awaitPicture(shown -> shown.engine().equals(offer.id()));

                assertThat(picture.isWhole()).isTrue();
            }
            driver.await(
                    () -> driver.text("facts").contains(jvm.get(3 % jvm.size()).id()));
            // Told after the picture.
            driver.await(() -> driver.text("message").isEmpty());
        }
    }

    @Tag("slow")
    @Test
    void devicesAreLookedForWhenTheListIsWantedButNotWhileAnEngineIsOpened() {
        CountDownLatch mayOpen = new CountDownLatch(1);
        EngineOffer slow = EngineOffer.working("slow", "a test", "opens late", () -> {
            try {
                mayOpen.await();
            } catch (InterruptedException problem) {
                throw new AssertionError(problem);
            }
            return JvmEngines.parallel().opener().get();
        });
        try (WindowDriver driver = WindowDriver.open(WindowScenes.tiny(), slow)) {
            ComboBox<?> list = driver.find("#engine .combo-box", ComboBox.class);
            driver.run(() -> {
                driver.window.workbench().panel().setVisible(true);
                list.requestFocus();
            });
            // Nothing but the opening keeps it from looking.
            driver.await(() -> driver.studio.pictureProperty().get().isPresent()
                    && driver.studio.drawingProperty().get().opening().isPresent());
            // If it looked all the same, on a thread of its own, it would be done about when this is.
            assertThat(Engines.offers()).isNotEmpty();
            for (int pulse = 0; pulse < 20; pulse++) {
                driver.pulse();
            }
            assertThat(hasDevices(list)).isFalse();
            assertThat(WindowDriver.call(() -> list.getItems().size())).isGreaterThan(3);

            mayOpen.countDown();
            driver.await(() -> hasDevices(list));
        } finally {
            mayOpen.countDown();
        }
    }

    @Test
    void devicesAreLookedForAtRest() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.awaitRest();
            driver.await(() -> hasDevices(driver.find("#engine .combo-box", ComboBox.class)));
        }
    }

    /** Or the line that says why there are none. */
    private static boolean hasDevices(ComboBox<?> list) {
        return WindowDriver.call(() -> list.getItems().stream().anyMatch(item -> Engines.isDevice(item.toString())));
    }

    @Test
    void anEngineThatDoesNotWorkIsSaidAndTheOldOneGoesOn() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.run(() -> driver.studio.chooseEngine(
                    EngineOffer.impossible("tornado:7:7", "a device", "none", "its driver is missing")));
            driver.await(() -> driver.text("message").contains("its driver is missing"));

            driver.run(() -> driver.studio.moveCamera(
                    camera -> WindowScenes.shipped("benchmark").camera()));
            assertThat(driver.awaitCurrentPicture().engine()).isEqualTo(JvmEngines.PARALLEL);
        }
    }

    @Test
    void theStatusLineTellsSceneEngineSizeSamplesAndBodies() {
        try (WindowDriver driver = WindowDriver.open()) {
            DrawnPicture picture = driver.awaitRest();
            Scene scene = picture.request().scene();

            assertThat(driver.text("facts"))
                    .contains(
                            scene.title().name(),
                            JvmEngines.PARALLEL,
                            picture.frame().width() + " × " + picture.frame().height(),
                            RefinementGoal.SHARP + " samples per pixel",
                            (scene.spheres().size() + 2) + " bodies");
        }
    }

    @Test
    void thePictureFollowsTheWindowAndTheResolution() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.run(() -> driver.stage.setWidth(WindowDriver.WIDTH + 100));
            driver.awaitPicture(picture -> picture.frame().width() == WindowDriver.WIDTH + 100);

            driver.run(() -> driver.studio.setResolution(ResolutionMode.HD));
            DrawnPicture large = driver.awaitPicture(picture -> picture.frame().width() == 1280);

            assertThat(large.frame().height()).isEqualTo(720);
        }
    }

    @Test
    void withoutRefiningThePictureIsDrawnAgainAndAgain() {
        try (WindowDriver driver = WindowDriver.open()) {
            DrawnPicture rest = driver.awaitRest();

            driver.run(() -> driver.studio.refiningProperty().set(false));

            driver.awaitPicture(picture -> picture.number() > rest.number() + 20 && picture.samples() == 1);
        }
    }

    @Test
    void editsAreTakenBackAndMadeAgain() {
        try (WindowDriver driver = WindowDriver.open()) {
            Scene before = WindowDriver.call(driver.studio::scene);
            driver.run(() -> driver.studio.edit(
                    "bounces", scene -> scene.withRendering(scene.rendering().withBounces(5))));
            assertThat(driver.awaitCurrentPicture()
                            .request()
                            .scene()
                            .rendering()
                            .bounces())
                    .isEqualTo(5);
            assertThat(driver.studio.document().editsProperty().get().changed()).isTrue();

            driver.run(driver.studio::undo);
            assertThat(driver.awaitCurrentPicture().request().scene()).isEqualTo(before);
            assertThat(driver.studio.document().editsProperty().get().redoable())
                    .contains("bounces");

            driver.run(driver.studio::redo);
            assertThat(driver.awaitCurrentPicture()
                            .request()
                            .scene()
                            .rendering()
                            .bounces())
                    .isEqualTo(5);
        }
    }
}
