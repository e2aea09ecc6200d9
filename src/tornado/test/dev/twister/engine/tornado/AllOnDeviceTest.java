package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.AllEngines;
import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.world.World;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The processor and every device together. */
class AllOnDeviceTest {
    @BeforeEach
    void requireADevice() {
        assertThat(Devices.offers()).isNotEmpty();
    }

    @Test
    void framesAreSequentials() {
        World world = SceneSamples.world(9, 50);
        world.setSettings(world.settings().withSize(160, 90));
        try (Engine all = Engines.open(AllEngines.ALL)) {
            // By all engines, and by one alone.
            for (int frame = 0; frame < 12; frame++) {
                Pictures.requireSequentials(all, world.snapshot());
            }
        }
    }
}
