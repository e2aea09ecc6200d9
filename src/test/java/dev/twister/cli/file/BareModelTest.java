package dev.twister.cli.file;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.mesh.MeshPose;
import dev.twister.oracle.Pictures;
import dev.twister.scene.Integrator;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.world.World;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A mesh without lights is about as bright with as without path tracing; its lamp is nearer than it seems. */
class BareModelTest {
    private static final int SIDE = 24;

    @TempDir
    private Path folder;

    @Test
    void pathTracingIsAsBrightAsWithout() throws Exception {
        ModelFile model = model();
        float[] whitted = picture(model, Integrator.WHITTED, 1);
        float[] traced = picture(model, Integrator.PATH, 1);
        assertThat(floor(traced) / floor(whitted)).isBetween(0.8, 1.4);
        assertThat(floor(picture(model, Integrator.PATH, 0)) / floor(whitted)).isBetween(0.8, 1.4);
    }

    @Test
    void theMeshIsAsBrightWithoutTheFloor() throws Exception {
        ModelFile model = model();
        double whole = middle(picture(model, Integrator.PATH, 1));
        assertThat(middle(picture(model.withoutPlane(), Integrator.PATH, 1)) / whole)
                .isBetween(0.8, 1.25);
    }

    private ModelFile model() throws Exception {
        Path file = folder.resolve("a.obj");
        Files.writeString(file, "v -1 0 0\nv 1 0 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
        return ModelFile.read(file, "", MeshPose.OF_FILE, _ -> {});
    }

    private static float[] picture(ModelFile model, Integrator integrator, double skyStrength) {
        Scene scene = model.scene();
        Rendering settings =
                scene.rendering().withSize(SIDE, SIDE).withSamplesPerPixel(64).withIntegrator(integrator);
        World world =
                model.world(model.under(scene.sky().withStrength(skyStrength)).withRendering(settings), _ -> {});
        return Pictures.radiance(JvmEngines.SEQUENTIAL, world.snapshot());
    }

    /** Before the mesh. */
    private static double floor(float[] radiance) {
        return mean(radiance, SIDE - 5, SIDE);
    }

    private static double middle(float[] radiance) {
        return mean(radiance, SIDE / 2 - 2, SIDE / 2 + 2);
    }

    /** Of the middle third of some rows. */
    private static double mean(float[] radiance, int firstRow, int endRow) {
        double sum = 0;
        for (int row = firstRow; row < endRow; row++) {
            for (int column = SIDE / 3; column < 2 * SIDE / 3; column++) {
                sum += radiance[3 * (row * SIDE + column) + 1];
            }
        }
        return sum / (endRow - firstRow) / (2 * SIDE / 3 - SIDE / 3);
    }
}
