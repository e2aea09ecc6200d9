package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.Scenes;
import dev.twister.kernel.Layout;
import dev.twister.scene.Integrator;
import dev.twister.scene.Scene;
import org.junit.jupiter.api.Test;

class RefinementGoalTest {
    private final Scene scene = Scenes.scene();

    @Test
    void smoothSurfacesSeenThroughAPinholeNeedFewSamples() {
        assertThat(RefinementGoal.samples(scene)).isEqualTo(RefinementGoal.SHARP);
        assertThat(RefinementGoal.samples(scene.withRendering(scene.rendering().withSamplesPerPixel(100))))
                .isEqualTo(100);
    }

    @Test
    void aLensAndRoughSurfacesNeedMany() {
        assertThat(RefinementGoal.samples(scene.withCamera(scene.camera().withAperture(0.1))))
                .isEqualTo(RefinementGoal.NOISY);
        for (int body : new int[] {Layout.PLANE, Layout.FIRST_SPHERE + 1}) {
            Scene rough = BodyMaterials.edited(
                    scene, body, old -> old.withReflectivity(64).withRoughness(0.5));
            assertThat(RefinementGoal.samples(rough)).isEqualTo(RefinementGoal.NOISY);
        }
    }

    @Test
    void pathTracingNeedsMany() {
        assertThat(RefinementGoal.samples(scene.withRendering(scene.rendering().withIntegrator(Integrator.PATH))))
                .isEqualTo(RefinementGoal.NOISY);
    }

    @Test
    void aMatteSurfaceIsTheSameHoweverRough() {
        Scene matte = BodyMaterials.edited(
                scene, Layout.FIRST_SPHERE, old -> old.withReflectivity(0).withRoughness(1));
        assertThat(RefinementGoal.samples(matte)).isEqualTo(RefinementGoal.SHARP);
    }
}
