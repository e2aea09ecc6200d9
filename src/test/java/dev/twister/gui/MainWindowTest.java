package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.javafx.tk.Toolkit;
import com.sun.scenario.animation.AbstractPrimaryTimer;
import dev.twister.gui.controls.Command;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.panel.Panel;
import dev.twister.scene.Rendering;
import java.lang.reflect.Field;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import javafx.geometry.Bounds;
import javafx.scene.control.Label;
import javafx.scene.image.ImageView;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.Test;

class MainWindowTest {
    private static final double ROUNDING = 1.5 / 255;
    private static final int MAGENTA = 0xFFFF00FF;
    private static final int[] PLACE = {100, 180};

    @Test
    void thePanelLeavesRoomForThePicture() {
        try (WindowDriver driver = WindowDriver.openWithPanel()) {
            Panel panel = driver.window.workbench().panel();
            assertThat(WindowDriver.call(driver.stage::getMinWidth))
                    .isGreaterThan(WindowDriver.call(panel::getWidth) + 200);
            driver.type(Command.PANEL.keys());
            assertThat(WindowDriver.call(driver.stage::getMinWidth)).isLessThan(WindowDriver.WIDTH + 1);
        }
    }

    @Test
    void atRestNoAnimationAsksForPulses() {
        // A caret blinks until its field is collected, in windows that other tests have closed, too.
        System.gc();
        try (WindowDriver driver = WindowDriver.openWithPanel()) {
            // The panel's numbers and their fields change.
            expose(driver, 1);
            driver.awaitRest();
            driver.await(() -> runningAnimations() == 0);
        }
    }

    /** JavaFX has no public way to ask. */
    private static int runningAnimations() {
        try {
            AbstractPrimaryTimer timer = Toolkit.getToolkit().getPrimaryTimer();
            return count(timer, "receiversLength") + count(timer, "animationTimersLength");
        } catch (ReflectiveOperationException problem) {
            throw new LinkageError("JavaFX has changed", problem);
        }
    }

    private static int count(AbstractPrimaryTimer timer, String name) throws ReflectiveOperationException {
        Field field = AbstractPrimaryTimer.class.getDeclaredField(name);
        field.setAccessible(true);
        return field.getInt(timer);
    }

    @Test
    void theScreenShowsTheEnginesPixels() {
        try (WindowDriver driver = WindowDriver.open()) {
            DrawnPicture picture = driver.awaitRest();
            for (int[] place : new int[][] {{10, 150}, {100, 180}, {200, 150}, {160, 130}}) {
                awaitShown(driver, picture, place);
            }
        }
    }

    @Test
    void aPictureThatIsDrawnAgainIsNotHandedToJavaFxAgainAndTheNextOneIs() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.run(() -> driver.studio.refiningProperty().set(false));
            // Unlike the one before: when it is seen, it has been painted.
            expose(driver, -1);
            DrawnPicture first = driver.awaitCurrentPicture();
            awaitShown(driver, first, PLACE);
            Bounds area = driver.pictureOnScreen();
            Color seen = driver.pixel(area.getMinX() + PLACE[0], area.getMinY() + PLACE[1]);

            AtomicInteger changes = new AtomicInteger();
            driver.run(() ->
                    driver.find(".image-view", ImageView.class).imageProperty().subscribe(changes::incrementAndGet));
            // Who is handed these pixels shows them.
            driver.run(() -> Arrays.fill(first.frame().argb(), MAGENTA));
            DrawnPicture later = driver.awaitPicture(picture -> picture.number() > first.number() + 20);
            driver.pulse();
            driver.pulse();
            assertThat(driver.pixel(area.getMinX() + PLACE[0], area.getMinY() + PLACE[1]))
                    .isEqualTo(seen);
            assertThat(later.frame()).isSameAs(first.frame());
            assertThat(changes).hasValue(0);

            expose(driver, 1);
            DrawnPicture bright = driver.awaitCurrentPicture();
            awaitShown(driver, bright, PLACE);
            assertThat(driver.pixel(area.getMinX() + PLACE[0], area.getMinY() + PLACE[1]))
                    .isNotEqualTo(seen);
        }
    }

    private static void expose(WindowDriver driver, double exposure) {
        driver.run(() -> driver.studio.edit("exposure", scene -> {
            Rendering settings = scene.rendering();
            return scene.withRendering(settings.withTone(exposure, settings.toneMap(), settings.srgb()));
        }));
    }

    @Test
    void aMessageThatIsCutOffIsWholeInItsTooltip() {
        String sentence = "/skies/huge.hdr: 2000000000 x 2000000000 texels, 1 x 1 to 16384 x 8192 are allowed";
        try (WindowDriver driver = WindowDriver.open()) {
            Label notice = driver.find("#notice", Label.class);
            driver.await(() -> {
                // Again where its time is over before it was laid out.
                driver.studio.notice(sentence);
                return notice.isTextTruncated();
            });
            driver.run(() -> {
                driver.studio.notice(sentence);
                assertThat(notice.getTooltip().getText().replace('\n', ' ')).isEqualTo(sentence);
            });
        }
    }

    /** JavaFX paints on a thread of its own, which no pulse of a window without a change waits for. */
    private static void awaitShown(WindowDriver driver, DrawnPicture picture, int... place) {
        int argb = picture.frame().argb()[place[1] * picture.frame().width() + place[0]];
        driver.await(() -> {
            Bounds area = driver.pictureOnScreen();
            Color seen = driver.pixel(area.getMinX() + place[0], area.getMinY() + place[1]);
            return Math.abs(seen.getRed() - (argb >> 16 & 0xFF) / 255.0) < ROUNDING
                    && Math.abs(seen.getGreen() - (argb >> 8 & 0xFF) / 255.0) < ROUNDING
                    && Math.abs(seen.getBlue() - (argb & 0xFF) / 255.0) < ROUNDING;
        });
    }
}
