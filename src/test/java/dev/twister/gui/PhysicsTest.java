package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.controls.Command;
import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.panel.PanelRow;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.kernel.Layout;
import dev.twister.physics.Simulation;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import javafx.scene.control.Button;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.shape.Polygon;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Bodies let go by hand. */
class PhysicsTest {
    private static final double HEIGHT = 6;
    private static WindowDriver driver;

    @BeforeAll
    static void open() {
        driver = WindowDriver.openWithPanel();
    }

    @AfterAll
    static void close() {
        driver.close();
    }

    @BeforeEach
    void startAnew() {
        driver.type(Command.RESET.keys());
        driver.run(() -> {
            driver.studio.refiningProperty().set(true);
            driver.studio.edit(
                    "one",
                    scene -> scene.withSpheres(List.of(high(scene.spheres().getFirst()))));
            driver.studio.endGesture();
        });
        driver.awaitCurrentPicture();
    }

    private static Sphere high(Sphere sphere) {
        return sphere.withPosition(new Vector3(0, HEIGHT, 3));
    }

    private static double height(DrawnPicture picture) {
        return picture.input().bodies().floats()[Layout.PLACE_STRIDE * Layout.FIRST_SPHERE + 1];
    }

    private static Scene scene() {
        return WindowDriver.call(driver.studio::scene);
    }

    private static Motion motion() {
        return WindowDriver.call(driver.studio.motion().motionProperty()::get);
    }

    private static PanelRow row(String name) {
        return WindowDriver.call(() -> driver.window.workbench().panel().rows().stream()
                .filter(row -> row.name().equals(name))
                .findFirst()
                .orElseThrow());
    }

    @Test
    void bodiesFallAndComeBackWhereTheSceneHasThem() {
        driver.type(row("Physics").keys());
        driver.type(KeyCode.SPACE);
        driver.awaitPicture(picture -> height(picture) < HEIGHT - 0.5);
        assertThat(scene().spheres().getFirst().position().y()).isEqualTo(HEIGHT);
        driver.type(KeyCode.SPACE);
        assertThat(motion()).isEqualTo(Motion.NONE);
        driver.awaitPicture(picture -> height(picture) == HEIGHT);
    }

    @Test
    void aStepIsAStepAndAPausedPictureRests() {
        driver.click(driver.find("#step", Button.class));
        driver.type(KeyCode.F7);
        assertThat(motion().running()).isFalse();
        assertThat(motion().steps()).isEqualTo(2);
        double fallen = 9.81 / 2 * Math.pow(2 * Simulation.STEP_SECONDS, 2);
        DrawnPicture picture =
                driver.awaitPicture(shown -> shown.request().motion().steps() == 2);
        assertThat(height(picture)).isCloseTo(HEIGHT - fallen, within(1e-4));
        double rest = height(picture);
        driver.awaitPicture(shown -> shown.samples() > 4);
        assertThat(height(WindowDriver.call(
                        () -> driver.studio.pictureProperty().get().orElseThrow())))
                .isEqualTo(rest);
    }

    @Test
    void pauseStopsTimeAndLetsItGoOn() {
        // However late the pause comes, a sphere that rises has not come to rest on the plane by then.
        driver.run(() -> driver.studio.edit(
                "gravity", scene -> scene.withPhysics(scene.physics().withGravity(new Vector3(0, 1, 0)))));
        driver.type(KeyCode.F5);
        driver.awaitPicture(picture -> height(picture) > HEIGHT + 0.1);
        driver.run(() -> driver.find("#pause", Button.class).fire());
        assertThat(motion().running()).isFalse();
        double paused = height(driver.awaitPicture(shown -> shown.samples() > 4));
        assertThat(paused).isGreaterThan(HEIGHT + 0.1);
        driver.type(KeyCode.F6);
        driver.awaitPicture(picture -> height(picture) > paused + 0.1);
        driver.type(KeyCode.F5);
    }

    @Tag("slow")
    @Test
    void gravityPullsTheOtherWay() {
        driver.type(KeyCode.F5);
        driver.type(row("Gravity y").keys());
        driver.type(KeyCode.END);
        assertThat(scene().physics().gravity().y()).isEqualTo(30);
        driver.awaitPicture(picture -> height(picture) > HEIGHT + 0.5);
        driver.type(KeyCode.F5);
    }

    @Tag("slow")
    @Test
    void anEditGoesOnFromWhereBodiesAre() {
        driver.type(KeyCode.F5);
        driver.awaitPicture(picture -> height(picture) < HEIGHT - 0.3);
        driver.type(KeyCode.F6);
        double paused = height(driver.awaitPicture(shown -> shown.samples() > 4));
        driver.run(() -> driver.studio.selection().select(Layout.FIRST_SPHERE));
        driver.type(row("Sphere x").keys());
        driver.type(KeyCode.RIGHT);
        Vector3 edited = scene().spheres().getFirst().position();
        assertThat(edited.y()).isCloseTo(paused, within(1e-6));
        assertThat(edited.x()).isGreaterThan(0);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene().spheres().getFirst().position().x()).isZero();
        driver.type(KeyCode.F5);
    }

    @Tag("slow")
    @Test
    void undoingTheMoveOfOneSphereLeavesTheOthersWhereTheyHaveMovedTo() {
        Sphere one = scene().spheres().getFirst();
        Sphere aside = one.withPosition(new Vector3(4, HEIGHT, 3));
        driver.run(() -> driver.studio.edit("two", scene -> scene.withSpheres(List.of(one, aside))));
        driver.run(driver.studio::endGesture);
        awaitSteps(20);
        moveAside(Layout.FIRST_SPHERE);
        awaitSteps(20);
        moveAside(Layout.FIRST_SPHERE + 1);
        double fallen = scene().spheres().getLast().position().y();
        assertThat(fallen).isLessThan(HEIGHT - 0.1);

        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);

        assertThat(scene().spheres().getFirst().position().x()).isZero();
        assertThat(scene().spheres().getLast().position()).isEqualTo(new Vector3(4, fallen, 3));
        driver.type(KeyCode.F5);
    }

    private static void moveAside(int body) {
        driver.run(() -> driver.studio.selection().select(body));
        driver.type(row("Sphere x").keys());
        driver.type(KeyCode.RIGHT);
    }

    @Test
    void anEditOfColorLightOrGravityDoesNotStopAFall() {
        double fallen = HEIGHT - height(awaitSteps(60));
        driver.run(() -> {
            driver.studio.edit("light", scene -> BodyEdits.moved(scene, BodyNumber.LIGHT, new Vector3(1, 7, 1)));
            driver.studio.edit(
                    "color",
                    scene -> BodyMaterials.edited(scene, Layout.FIRST_SPHERE, old -> old.withColor(new Rgb(0, 1, 0))));
            driver.studio.edit(
                    "gravity", scene -> scene.withPhysics(scene.physics().withGravity(new Vector3(0, 0, 0))));
        });
        assertThat(scene().spheres().getFirst().position().y()).isEqualTo(HEIGHT);
        assertThat(height(driver.awaitCurrentPicture())).isEqualTo((float) (HEIGHT - fallen));
        DrawnPicture later = awaitSteps(20);
        // Without gravity only the speed that it had takes it further: 9.81 m/s^2 for half a second.
        assertThat(height(later)).isCloseTo(HEIGHT - fallen - 9.81 / 2 / 6, within(1e-3));
        assertThat(later.input().bodies().floats()).startsWith(1, 7, 1);
        driver.type(KeyCode.F5);
        assertThat(height(driver.awaitPicture(
                        picture -> !picture.request().motion().isOn())))
                .isEqualTo(HEIGHT);
    }

    @Test
    void farFromZeroABodyIsWhereItIsSeen() {
        Vector3 far = new Vector3(5000, 0, 5000);
        driver.run(() -> {
            driver.studio.edit(
                    "far",
                    scene -> scene.withSpheres(
                            List.of(scene.spheres().getFirst().withPosition(new Vector3(far.x(), HEIGHT, far.z())))));
            driver.studio.endGesture();
            driver.studio.moveCamera(camera -> camera.withPosition(new Vector3(far.x(), 2, far.z() - 8)));
        });
        DrawnPicture fallen = awaitSteps(10);
        Vector3 now = WindowDriver.call(() -> driver.studio.bodies().position(Layout.FIRST_SPHERE));

        assertThat(fallen.input().bodies().origin()).isNotEqualTo(new Vector3(0, 0, 0));
        assertThat(now.x()).isCloseTo(far.x(), within(1e-3));
        assertThat(now.z()).isCloseTo(far.z(), within(1e-3));
        assertThat(now.y()).isBetween(HEIGHT - 1, HEIGHT - 0.01);
    }

    /** Steps so many times more. */
    private static DrawnPicture awaitSteps(int more) {
        driver.run(() -> {
            for (int step = 0; step < more; step++) {
                driver.studio.motion().stepOnce();
            }
        });
        long steps = motion().steps();
        return driver.awaitPicture(picture -> picture.request().motion().steps() == steps);
    }

    @Tag("slow")
    @Test
    void aResetWhileBodiesMoveIsTakenBackToWhereTheyStarted() {
        driver.run(() -> {
            List<Sphere> spheres =
                    new ArrayList<>(driver.studio.document().original().spheres());
            spheres.set(0, high(spheres.getFirst()));
            driver.studio.edit("as many as at first", scene -> scene.withSpheres(spheres));
            driver.studio.endGesture();
        });
        Scene before = scene();
        awaitSteps(20);
        driver.type(Command.RESET.keys());
        Scene reset = scene();
        assertThat(reset).isEqualTo(WindowDriver.call(driver.studio.document()::original));

        driver.type(Command.UNDO.keys());
        assertThat(scene()).isEqualTo(before);
        driver.type(Command.REDO.keys());
        assertThat(scene()).isEqualTo(reset);
        driver.type(Command.UNDO.keys());
        assertThat(scene()).isEqualTo(before);
    }

    @Tag("slow")
    @Test
    void thePanelShowsWhereTheSelectedSphereIs() {
        driver.run(() -> driver.studio.selection().select(Layout.FIRST_SPHERE));
        TextField field = driver.find("#sphere-y .text-field", TextField.class);
        assertThat(Double.parseDouble(field.getText())).isEqualTo(HEIGHT);
        driver.type(KeyCode.F5);
        driver.await(() -> Double.parseDouble(field.getText()) < HEIGHT - 0.5);
        driver.type(KeyCode.F6);
        double paused = height(driver.awaitPicture(shown -> shown.samples() > 4));
        driver.await(() -> Math.abs(Double.parseDouble(field.getText()) - paused) < 0.006);
        assertThat(scene().spheres().getFirst().position().y()).isEqualTo(HEIGHT);
        driver.type(KeyCode.F5);
        assertThat(Double.parseDouble(WindowDriver.call(field::getText))).isEqualTo(HEIGHT);
    }

    @Tag("slow")
    @Test
    void aFieldWithTheFocusKeepsItsTextWhileItsSphereMoves() {
        driver.run(() -> driver.studio.selection().select(Layout.FIRST_SPHERE));
        TextField field = driver.find("#sphere-y .text-field", TextField.class);
        driver.run(() -> {
            field.requestFocus();
            field.selectRange(0, 1);
        });
        driver.type(KeyCode.F5);
        driver.awaitPicture(shown -> shown.request().motion().isOn() && height(shown) < HEIGHT - 0.5);
        // The camera is part of the scene.
        driver.run(() -> driver.studio.moveCamera(camera -> camera.withYawDegrees(1)));
        driver.pulse();
        assertThat(Double.parseDouble(WindowDriver.call(field::getText))).isEqualTo(HEIGHT);
        assertThat(WindowDriver.call(field::getSelection).getLength()).isOne();

        driver.run(() -> {
            field.selectAll();
            field.replaceSelection("2");
        });
        driver.awaitCurrentPicture();
        driver.type(KeyCode.ENTER);
        assertThat(scene().spheres().getFirst().position().y()).isEqualTo(2);
    }

    @Tag("slow")
    @Test
    void physicsSaysWhatFalls() {
        driver.type(KeyCode.F5);
        assertThat(driver.notice()).isEqualTo("Physics on: 1 sphere");
        driver.type(KeyCode.F6);
        assertThat(driver.notice()).isEqualTo("Paused");
        driver.type(KeyCode.F5);
        assertThat(driver.notice()).isEqualTo("Physics off: bodies are where the scene has them");
        driver.run(() -> driver.studio.edit("none", scene -> scene.withSpheres(List.of())));
        driver.type(KeyCode.F5);
        assertThat(driver.notice()).isEqualTo("Physics on, but the scene has no spheres");
    }

    @Tag("slow")
    @Test
    void aPouredSphereIsSelectedAndFollowed() {
        driver.run(() -> driver.studio.edit(
                "pour",
                scene -> WindowScenes.quick(WindowScenes.shipped("pour-1000")).withRendering(scene.rendering())));
        driver.type(KeyCode.F5);
        int first = Layout.FIRST_SPHERE + scene().spheres().size();
        driver.awaitPicture(
                shown -> shown.request().motion().isOn() && shown.input().bodyCount() > first);
        driver.run(() -> driver.studio.selection().select(first));
        Polygon outline = driver.find("#outline", Polygon.class);
        driver.await(() -> !outline.getPoints().isEmpty());
        assertThat(driver.text("selection-hint")).startsWith("Poured sphere 1.");
        driver.type(KeyCode.DELETE);
        assertThat(driver.notice()).isEqualTo("A poured sphere can't be deleted");
        driver.type(KeyCode.F2);
        assertThat(WindowDriver.call(driver.studio.selection()::active)).isEqualTo(BodyNumber.LIGHT);

        driver.run(() -> driver.studio.selection().select(first));
        driver.type(KeyCode.F5);
        assertThat(WindowDriver.call(driver.studio.selection()::active)).isEqualTo(Layout.NOTHING);
    }

    @Test
    void spheresAreThrownAndThatCanBeUndone() {
        Scene before = scene();
        driver.click(driver.find("#randomize", Button.class));
        driver.await(() -> !driver.studio.scene().spheres().equals(before.spheres()));
        driver.awaitCurrentPicture();
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(before);
    }

    @Test
    void anEditWhileSpheresAreThrownStaysAsItIs() {
        Rgb green = new Rgb(0, 1, 0);
        Sphere before = editWhileSpheresAreThrown(
                        scene -> BodyMaterials.edited(scene, Layout.FIRST_SPHERE, old -> old.withColor(green)))
                .spheres()
                .getFirst();

        driver.await(() -> isThrown(before));
        assertThat(scene().spheres().getFirst().color()).isEqualTo(green);
        driver.type(Command.UNDO.keys());
        assertThat(scene().spheres()).containsExactly(before);
    }

    @Test
    void spheresThatWereEditedWhileTheyWereThrownAreThrownAgain() {
        Scene before = editWhileSpheresAreThrown(scene -> {
            Scene larger =
                    PropertyNumbers.ofBody(scene, Layout.FIRST_SPHERE).getLast().write(scene, 2);
            return larger.withBodies(
                    larger.bodies().with(List.of(larger.spheres().getFirst())));
        });
        assertThat(before.spheres()).hasSize(2);

        driver.await(() -> isThrown(before.spheres().getFirst()));
        assertThat(scene().spheres())
                .hasSize(2)
                .allSatisfy(sphere -> assertThat(sphere.radius()).isEqualTo(2));
        driver.type(Command.UNDO.keys());
        assertThat(scene()).isEqualTo(before);
    }

    /** JavaFX's thread shows what was thrown, and is busy with the edit until then. */
    private static Scene editWhileSpheresAreThrown(UnaryOperator<Scene> edit) {
        return WindowDriver.call(() -> {
            driver.find("#randomize", Button.class).fire();
            driver.studio.edit("meanwhile", edit);
            driver.studio.endGesture();
            return driver.studio.scene();
        });
    }

    private static boolean isThrown(Sphere before) {
        return !driver.studio.scene().spheres().getFirst().position().equals(before.position());
    }

    @Test
    void aSceneThatIsOpenedWhileAnothersSpheresAreThrownKeepsItsOwn() {
        Scene opened = scene();
        driver.run(() -> {
            Button randomize = driver.find("#randomize", Button.class);
            randomize.fire();
            driver.studio.show(new OpenedScene(Path.of("test.json"), opened));
            // What is done after it tells that it is done.
            randomize.fire();
        });
        driver.await(() -> isThrown(opened.spheres().getFirst()));

        driver.type(Command.UNDO.keys());
        assertThat(scene()).isEqualTo(opened);
        Scene original = WindowScenes.tiny();
        driver.run(() -> driver.studio.show(new OpenedScene(Path.of("test.json"), original)));
    }
}
