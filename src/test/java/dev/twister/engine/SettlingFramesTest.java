package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.oracle.Crowds;
import dev.twister.scene.Integrator;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import org.junit.jupiter.api.Test;

class SettlingFramesTest {
    @Test
    void picturesWithGuidesAreDrawn() {
        World world = Crowds.world(20, 32, 18);
        world.setSettings(world.settings().withIntegrator(Integrator.PATH).withSamplesPerPixel(1));
        FrameInput guided = world.snapshot().withGuides();
        try (Engine engine = JvmEngines.parallel().opener().get()) {
            assertThat(new SettlingFrames(engine, SettlingFrames.small(guided)).draw())
                    .isPositive();
        }
    }
}
