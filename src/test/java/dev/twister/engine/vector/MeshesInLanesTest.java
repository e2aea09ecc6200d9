package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.JvmEngines;
import dev.twister.image.Frame;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.Pictures;
import dev.twister.oracle.RandomMeshes;
import dev.twister.world.FrameInput;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Lanes decline meshes: the scalar kernel draws them. */
class MeshesInLanesTest {
    private static final int SCENES = 10;

    @ParameterizedTest(name = "{0} bits")
    @ValueSource(ints = {128, 256, 512})
    void meshesAreTheKernels(int bits) {
        try (Engine engine = WidthLoader.open(bits, 2)) {
            for (int seed = 0; seed < SCENES; seed++) {
                LitScene scene = RandomMeshes.scene(new Random(seed), 3);
                FrameInput input = scene.world().snapshot();
                Frame frame = Frame.ofPixels(input.width(), input.height());
                engine.render(input, frame);
                assertThat(frame.argb()).isEqualTo(Pictures.argb(JvmEngines.SEQUENTIAL, input));
            }
        }
    }
}
