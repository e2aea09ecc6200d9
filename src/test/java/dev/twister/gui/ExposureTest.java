package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.ExposureMeter;
import dev.twister.gui.controls.Command;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.picture.ClippingView;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.image.Histogram;
import dev.twister.scene.Scene;
import dev.twister.world.StageOrView;
import java.util.Optional;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Labeled;
import javafx.scene.paint.Color;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The histogram, what is clipped, and the exposure that the picture asks for. */
class ExposureTest {
    private static final double BRIGHTEST = 20;
    private WindowDriver driver;

    @BeforeEach
    void open() {
        driver = WindowDriver.openWithPanel();
    }

    @AfterEach
    void close() {
        driver.close();
    }

    @Tag("slow")
    @Test
    void theSharesOfClippedPixelsAreSaid() {
        expose(BRIGHTEST);
        DrawnPicture bright = driver.awaitCurrentPicture();
        Histogram all = Histogram.of(
                bright.frame().argb(), bright.frame().width(), bright.frame().argb().length);
        driver.await(() -> text("clipped").contains("Clipped: 100 % white"));
        assertThat(all.whiteShare()).isGreaterThan(0.99);

        expose(-BRIGHTEST);
        driver.await(() -> text("clipped").equals("Clipped: 0 % white, 100 % black"));
    }

    @Tag("slow")
    @Test
    void whatHasNoExposureHasNoHistogram() {
        driver.run(() -> driver.studio.setShown(StageOrView.NORMAL));
        driver.await(() -> text("clipped").equals("Normal has no exposure: its colors are not light"));
        assertThat(auto().isDisabled()).isTrue();

        Scene before = WindowDriver.call(driver.studio::scene);
        driver.run(() -> driver.find(".picture", Node.class).requestFocus());
        driver.type(Command.AUTO_EXPOSURE.keys());
        assertThat(driver.notice()).isEqualTo("Normal has no exposure: its colors are not light");
        assertThat(WindowDriver.call(driver.studio::scene)).isEqualTo(before);
        driver.run(() -> driver.studio.setShown(StageOrView.BEAUTY));
        driver.await(() -> text("clipped").startsWith("Clipped: "));
        assertThat(auto().isDisabled()).isFalse();
    }

    @Test
    void clippedPixelsAreMarkedOverThePicture() {
        expose(BRIGHTEST);
        awaitInTheMiddle(Color.WHITE);

        driver.type(Command.CLIPPING.keys());
        awaitInTheMiddle(color(ClippingView.WHITE));
        CheckBox box = driver.find("#show-clipping .check-box", CheckBox.class);
        assertThat(box.isSelected()).isTrue();

        expose(-BRIGHTEST);
        DrawnPicture black = driver.awaitCurrentPicture();
        awaitInTheMiddle(color(ClippingView.BLACK));
        // What is saved and recorded has no marks.
        assertThat(black.frame().argb()).containsOnly(0xFF000000);

        driver.run(box::fire);
        awaitInTheMiddle(Color.BLACK);
    }

    @Tag("slow")
    @Test
    void autoExposureIsOneEditByTheGatheredLight() {
        expose(6);
        DrawnPicture rest = driver.awaitRest();
        double measured = ExposureMeter.stops(rest.input()).orElseThrow();

        driver.run(auto()::fire);
        driver.await(() -> driver.notice().startsWith("Exposure: "));

        double set = WindowDriver.call(driver.studio::scene).rendering().exposure();
        assertThat(set).isCloseTo(measured, Offset.offset(0.1));
        assertThat(driver.notice())
                .isEqualTo("Exposure: " + PropertyNumbers.EXPOSURE.scale().text(set) + " stops");
        driver.type(Command.UNDO.keys());
        assertThat(WindowDriver.call(driver.studio::scene).rendering().exposure())
                .isEqualTo(6);
    }

    @Tag("slow")
    @Test
    void aBlackPictureHasNoExposure() {
        driver.run(() -> {
            driver.studio.edit("dark", scene -> scene.withSky(scene.sky().withStrength(0)));
            driver.studio.moveCamera(camera -> camera.withPitchDegrees(-90));
        });
        driver.awaitCurrentPicture();
        Scene before = WindowDriver.call(driver.studio::scene);
        driver.clearNotice();

        driver.run(auto()::fire);
        driver.await(() -> !driver.notice().isEmpty());

        assertThat(driver.notice()).isEqualTo("The picture is black: its exposure can't be measured");
        assertThat(WindowDriver.call(driver.studio::scene)).isEqualTo(before);
    }

    private void expose(double stops) {
        driver.run(() -> driver.studio.edit("exposure", scene -> PropertyNumbers.EXPOSURE.write(scene, stops)));
        driver.awaitCurrentPicture();
    }

    /** A picture is on the screen some pulses after it is there. */
    private void awaitInTheMiddle(Color wanted) {
        Bounds place = driver.pictureOnScreen();
        driver.await(() -> driver.pixel(place.getCenterX(), place.getCenterY()).equals(wanted));
    }

    private Button auto() {
        return driver.find("#auto-exposure", Button.class);
    }

    private String text(String id) {
        return Optional.ofNullable((Labeled) driver.stage.getScene().getRoot().lookup("#" + id))
                .map(Labeled::getText)
                .orElseThrow();
    }

    private static Color color(int argb) {
        return Color.rgb((argb >> 16) & 255, (argb >> 8) & 255, argb & 255);
    }
}
