package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import dev.twister.ChildJvm;
import dev.twister.engine.Engine;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.image.Frame;
import dev.twister.oracle.Crowds;
import dev.twister.scene.Integrator;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import jdk.incubator.vector.FloatVector;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Checks that warm frames do not allocate. Each vector width that the CPU supports runs in a JVM of its own, as for a
 * user: a JVM that has run several widths compiles them worse.
 */
final class AllocationTest {
    /** Allowance for the frame's times and for the JVM itself; boxed vectors would take megabytes. */
    private static final long BYTES_A_FRAME = 16_384;

    /** CPU time of all threads together, after which warm-up has failed, however busy the machine is. */
    private static final long MOST_NANOS = 240_000_000_000L;

    private static final int FRAMES = 20;
    private static final int TRIES = 3;

    @ParameterizedTest
    @CsvSource({"128, benchmark", "256, benchmark", "512, benchmark", "256, crowd of 1000", "512, crowd of 1000"})
    void allocatesNextToNothingInAWarmFrame(int bits, String scene) throws IOException, InterruptedException {
        requireWarmAt(bits, scene);
    }

    /** Their many stages take long to be compiled. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({
        "512, crowd of 100",
        "512, pour-on-mesh",
        "256, glass",
        "256, gallery of metal",
        "256, glass of paths",
        "256, crowd of 1000 of paths",
        "256, lamps of paths",
        "512, weekend of paths",
        "512, cornell of paths",
        "512, knot of paths",
        "512, atrium of paths",
        "512, maps of paths",
        "512, glass",
    })
    void allocatesNextToNothingWithManyMaterials(int bits, String scene) throws IOException, InterruptedException {
        requireWarmAt(bits, scene);
    }

    private static void requireWarmAt(int bits, String scene) throws IOException, InterruptedException {
        assumeThat(bits)
                .as("vector width in bits; wider vectors than the CPU's are boxed")
                .isLessThanOrEqualTo(FloatVector.SPECIES_PREFERRED.vectorBitSize());
        assumeIsTested(bits);
        requireWarm(bits, Lanes.FUSED, scene);
    }

    /** CPUs without fused multiply-add have four lanes. */
    @ParameterizedTest
    @ValueSource(strings = {"benchmark", "crowd of 1000"})
    void allocatesNextToNothingWithoutFusedMultiplyAdd(String scene) throws IOException, InterruptedException {
        assumeIsTested(128);
        requireWarm(128, false, scene);
    }

    private static void assumeIsTested(int bits) {
        assumeThat(WidthLoader.WIDTHS)
                .as("widths; -Dtwister.widths=all tests all")
                .contains(bits);
    }

    private static void requireWarm(int bits, boolean fused, String scene) throws IOException, InterruptedException {
        // The order in which stages are compiled varies: in a few JVMs of many, one stage stays boxed.
        StringBuilder outputs = new StringBuilder();
        for (int time = 0; time < TRIES && outputs.indexOf(WarmFrames.WARM) < 0; time++) {
            outputs.append(warmUp(bits, fused, scene));
        }
        assertThat(outputs).as(scene).contains(WarmFrames.WARM);
    }

    /** Returns the output of a JVM with this vector width. */
    private static String warmUp(int bits, boolean fused, String scene) throws IOException, InterruptedException {
        List<String> width = List.of("-D" + Lanes.BITS_PROPERTY + "=" + bits, "-D" + Lanes.FMA_PROPERTY + "=" + fused);
        Process java = ChildJvm.start(
                ChildJvm.asLaunched(width, WarmFrames.class, scene).redirectErrorStream(true));
        String output = new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        java.waitFor();
        return output;
    }

    /** Renders until frames hardly allocate; fails if that never happens. */
    static final class WarmFrames {
        static final String WARM = "warm: ";
        private static final int SAMPLES = 4;
        private static final String CROWD = "crowd of ";
        private static final String METAL = " of metal";
        private static final String PATHS = " of paths";
        private static final OperatingSystemMXBean SYSTEM =
                ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

        private WarmFrames() {}

        public static void main(String[] arguments) {
            World world = world(arguments[0].replace(PATHS, ""));
            if (arguments[0].endsWith(PATHS)) {
                world.setSettings(world.settings()
                        .withIntegrator(Integrator.PATH)
                        .withSize(160, 96)
                        .withSamplesPerPixel(4));
            }
            FrameInput input = world.snapshot();
            Frame frame = Frame.ofPixels(input.width(), input.rows());
            // Made lanes from the start.
            try (Engine vector = VectorEngines.open(2, VectorEngine.CROWD)) {
                long allocated = Long.MAX_VALUE;
                while (allocated > BYTES_A_FRAME && SYSTEM.getProcessCpuTime() < MOST_NANOS) {
                    allocated = bytesAFrame(vector, input, frame);
                }
                System.out.println((allocated > BYTES_A_FRAME ? "still cold: " : WARM) + allocated + " bytes a frame");
            }
        }

        private static World world(String scene) {
            return scene.startsWith(CROWD)
                    ? Crowds.world(Integer.parseInt(scene.substring(CROWD.length())), 640, 360)
                    : shipped(scene);
        }

        private static World shipped(String name) {
            Scene plain = SceneReader.read(Path.of("scenes", name.replace(METAL, "") + ".json"));
            Scene scene = name.endsWith(METAL) ? ofMetal(plain) : plain;
            SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
            World world = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
            // Frames of many samples would take most of the time allowed.
            world.setSettings(world.settings().withSize(640, 360).withSamplesPerPixel(SAMPLES));
            return world;
        }

        private static Scene ofMetal(Scene plain) {
            return plain.withMeshes(plain.meshes().stream()
                    .map(mesh -> mesh.material()
                            .map(material -> mesh.withMaterial(material.withMetallic(1)))
                            .orElse(mesh))
                    .toList());
        }

        private static long bytesAFrame(Engine vector, FrameInput input, Frame frame) {
            ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
            long before = threads.getTotalThreadAllocatedBytes();
            for (int i = 0; i < FRAMES; i++) {
                vector.render(input, frame);
            }
            return (threads.getTotalThreadAllocatedBytes() - before) / FRAMES;
        }
    }
}
