package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.light.Lights;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** A device of TornadoVM's in the window, taking turns with the JVM. */
class DeviceInWindowTest {
    private static final int TURNS = 3;

    @Test
    void aDeviceComesAndGoesDrawsAtRestAndFollowsEdits() {
        Optional<EngineOffer> device = Engines.offers().stream()
                .filter(EngineOffer::works)
                .filter(offer -> Engines.isDevice(offer.id()))
                .findFirst();
        assumeTrue(device.isPresent(), "no device to test the TornadoVM engine on");
        EngineOffer offer = device.orElseThrow();
        try (WindowDriver driver = WindowDriver.open()) {
            for (int turn = 0; turn < TURNS; turn++) {
                driver.run(() -> driver.studio.chooseEngine(offer));
                driver.awaitPicture(picture -> picture.engine().equals(offer.id()));
                DrawnPicture rest = driver.awaitRest();
                assertThat(rest.engine()).isEqualTo(offer.id());
                assertThat(rest.isWhole()).isTrue();

                Rgb color = new Rgb(0.1 * turn, 1, 1);
                driver.run(() -> driver.studio.edit(
                        "light",
                        scene -> scene.withLights(
                                Lights.of(withColor(scene.lights().first(), color)))));
                assertThat(driver.awaitCurrentPicture().engine()).isEqualTo(offer.id());

                driver.run(() -> driver.studio.chooseEngine(JvmEngines.parallel()));
                driver.awaitPicture(picture -> picture.engine().equals(JvmEngines.PARALLEL));
            }
            // Told after the picture.
            driver.await(() -> driver.text("message").isEmpty());
        }
    }

    private static Light withColor(Light light, Rgb color) {
        return light.withColor(color);
    }
}
