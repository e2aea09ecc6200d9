package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.engine.EngineException;
import dev.twister.image.Frame;
import dev.twister.scene.Rendering;
import dev.twister.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import uk.ac.manchester.tornado.api.common.TornadoDevice;

/** If a device cannot do something, the error states why; plain Java never silently replaces the device. */
@Timeout(300)
class DeviceFailureTest {
    private static void drawWith(DrawTask kernel) {
        TornadoDevice device = Devices.all().getFirst();
        World world = SceneSamples.world(1, 2);
        world.setSettings(Rendering.DEFAULT.withSize(16, 8));
        try (TornadoEngine engine = new TornadoEngine("tornado:0:0", "the first device", device, kernel)) {
            engine.render(world.snapshot(), Frame.ofPixels(16, 8));
        }
    }

    @Test
    void anObjectKeptInALoopIsAnErrorWithTheCompilersMessage() {
        assertThatThrownBy(() -> drawWith(BrokenKernels::keepingObjects))
                .isInstanceOf(EngineException.class)
                .hasMessageContaining("compile")
                .hasMessageContaining("the first device");
    }

    @Test
    void colorsAndTracesInTornadosMessagesAreLeftOut() {
        String message = "\u001B[31mBailout is disabled. Reason: \u001B[31mUnable to compile\nthe task\u001B[0m"
                + " Stacktrace: [a.B.c(B.java:613), d.E.f(E.java:638)]\u001B[0m\u001B[0m";
        assertThat(DeviceFailure.message("the first device", new IllegalStateException(message)))
                .isEqualTo("TornadoVM could not compile or run the kernel on the first device:"
                        + " Bailout is disabled. Reason: Unable to compile the task");
        assertThat(DeviceFailure.message("the first device", new IllegalStateException("\u001B[0m")))
                .endsWith(": IllegalStateException");
    }

    @Test
    void pixelsLeftUndrawnAreAnError() {
        assertThatThrownBy(() -> drawWith(BrokenKernels::idle))
                .isInstanceOf(EngineException.class)
                .hasMessageContaining("undrawn");
    }

    @Test
    void theAdviceOnMemoryIsMoreThanWhatIsSet() {
        assertThat(DeviceFailure.moreGigabytes("")).isEqualTo(8);
        assertThat(DeviceFailure.moreGigabytes("512MB")).isEqualTo(8);
        assertThat(DeviceFailure.moreGigabytes("12GB")).isEqualTo(24);
    }
}
