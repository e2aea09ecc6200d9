package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.bench.report.WindowRates;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.kernel.Layout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;

/** What {@code gui --measure} does, in pulses of a clock of its own. */
class CircleMeasurementTest {
    private static final long TENTH_SECOND = TimeUnit.MILLISECONDS.toNanos(100);

    @Test
    void theCameraGoesAroundAndPicturesOf720pAreCounted() {
        AtomicReference<Optional<WindowRates>> told = new AtomicReference<>(Optional.empty());
        try (WindowDriver driver = WindowDriver.open()) {
            DrawnPicture before = driver.awaitCurrentPicture();
            CircleMeasurement measurement =
                    WindowDriver.call(() -> new CircleMeasurement(driver.studio, 0.1, 0.4, told::set));
            long clock = System.nanoTime();
            while (told.get().isEmpty()) {
                clock += TENTH_SECOND;
                long now = clock;
                driver.run(() -> measurement.pulse(now));
                driver.pulse();
                driver.awaitCurrentPicture();
            }
            assertThat(eye(driver.awaitCurrentPicture())).isNotEqualTo(eye(before));
        }
        WindowRates rates = told.get().orElseThrow();
        assertThat(rates.engine()).isEqualTo(JvmEngines.PARALLEL);
        assertThat(rates.settings().width()).isEqualTo(1280);
        assertThat(rates.settings().height()).isEqualTo(720);
        assertThat(rates.display().pulsesPerSecond()).isBetween(7.0, 13.0);
    }

    @Test
    void anotherEngineThanTheChosenOneIsNotMeasured() {
        List<Optional<WindowRates>> told = new ArrayList<>();
        try (WindowDriver driver = WindowDriver.open()) {
            driver.awaitCurrentPicture();
            driver.run(() -> driver.studio.chooseEngine(
                    EngineOffer.impossible("tornado:7:7", "a device", "none", "its driver is missing")));
            driver.awaitCurrentPicture();
            CircleMeasurement measurement =
                    WindowDriver.call(() -> new CircleMeasurement(driver.studio, 0.1, 0.4, told::add));
            long start = System.nanoTime();
            driver.run(() -> measurement.pulse(start + TimeUnit.SECONDS.toNanos(59)));
            assertThat(told).isEmpty();
            driver.run(() -> measurement.pulse(start + TimeUnit.SECONDS.toNanos(61)));
            driver.run(() -> measurement.pulse(start + TimeUnit.SECONDS.toNanos(62)));
        }
        assertThat(told).containsExactly(Optional.empty());
    }

    /** The camera's x, in meters. */
    private static float eye(DrawnPicture picture) {
        return picture.input().view().frame()[Layout.CAMERA_POSITION];
    }
}
