package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.kernel.Layout;
import dev.twister.mesh.MeshFile;
import dev.twister.oracle.MeshShapes;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rgb;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import dev.twister.world.hierarchy.SphereHierarchy;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import uk.ac.manchester.tornado.api.common.TornadoDevice;
import uk.ac.manchester.tornado.api.exceptions.TornadoExecutionPlanException;

/**
 * Compares every helper of the kernel on every device with plain Java, on random input. Devices may round square roots
 * and quotients differently, hence the tolerances; where rounding decides between hit and miss, a few items may differ
 * entirely.
 */
class HelpersOnDeviceTest {
    private static final int ITEMS = 20_000;
    private static final int BODIES = 42;
    private static final int LOOKS = Layout.LOOK_STRIDE * BODIES;
    private static final int PLACED = Layout.PLACE_STRIDE * BODIES + Layout.spheresLength(BODIES - Layout.FIRST_SPHERE);
    private static final int MANY_BODIES = 1000;
    private static final int MOST_SAMPLES = 500;
    private static final int MESHES = 3;

    /** A plane that casts no shadow. */
    private static final float[] OUT_OF_THE_WAY = {0, -90, 0, 1};

    /** Small enough for a hierarchy of some depth. */
    private static final int MOST_IN_LEAF = 2;

    /**
     * A helper and its tolerance.
     *
     * @param tolerance the largest {@code |device - java| / max(1, |java|)}
     * @param outliers allowed number of outputs beyond the tolerance
     * @param firstTable length of its first table, which every item reads
     */
    private record Helper(
            String name,
            int inputs,
            int outputs,
            double tolerance,
            int outliers,
            int firstTable,
            int secondTable,
            int thirdTable) {
        Helper(String name, int inputs, int outputs, double tolerance, int outliers) {
            this(name, inputs, outputs, tolerance, outliers, 1, 1, 1);
        }
    }

    private static final List<Helper> HELPERS = List.of(
            new Helper("floor", 1, 1, 0, 0),
            new Helper("inverseRoot", 1, 1, 1e-6, 0),
            new Helper("pow", 2, 1, 3e-5, 0),
            new Helper("atan2", 2, 1, 1e-6, 0),
            new Helper("viewport", 4, 2, 2e-6, 0),
            new Helper("sphere", 7, 1, 2e-4, 20),
            new Helper("plane", 8, 1, 1e-5, 4),
            new Helper("hit", 8, 2, 1e-3, 20, PLACED, LOOKS, 1),
            new Helper("walk", 8, 2, 1e-3, 20, PLACED, LOOKS, 1),
            new Helper("sky", 5, 5, 2e-4, 0, 3 * 32 * 16, 1, 1),
            new Helper("facet", 10, 3, 1e-4, 20, Layout.DISC + Layout.SAMPLE_STRIDE, 1, 1),
            new Helper("refraction", 4, 2, 1e-4, 4),
            new Helper("texture", 4, 1, 1e-5, 0, 3 + 3 * 32 * 16, 1, 1),
            new Helper("light", 6, 3, 1e-4, 0),
            new Helper("triangle", 15, 2, 1e-3, 4, Layout.INSTANCE_STRIDE, 1, 1),
            // One step of 255 more or less where the rounding falls between two.
            new Helper("tone", 4, 2, 1e-2, 0));

    static Stream<Object[]> helpersOnDevices() {
        return Devices.named().stream()
                .flatMap(device ->
                        HELPERS.stream().map(helper -> new Object[] {Named.of(helper.name(), helper), device}));
    }

    static List<Named<TornadoDevice>> devices() {
        return Devices.named();
    }

    @ParameterizedTest(name = "{0} on {1}")
    @MethodSource("helpersOnDevices")
    void helperGivesTheSameOnTheDevice(Object helperOnDevice, TornadoDevice device)
            throws TornadoExecutionPlanException {
        Helper helper = (Helper) helperOnDevice;
        try (HelperRun run = new HelperRun(
                helper.name(),
                device,
                ITEMS,
                helper.inputs(),
                helper.outputs(),
                helper.firstTable(),
                helper.secondTable(),
                helper.thirdTable())) {
            Random random = new Random(helper.name().hashCode());
            fillTables(run, random);
            for (int item = 0; item < ITEMS; item++) {
                put(run.input, item, input(helper.name(), item, random));
            }
            requireNear(run, helper.tolerance(), helper.outliers());
        }
    }

    /** Where rounding decides between two emitters, a few items may differ. */
    @ParameterizedTest(name = "tree of lights on {0}")
    @MethodSource("devices")
    void lightsAreChosenAsOnTheDevice(TornadoDevice device) throws TornadoExecutionPlanException {
        Random random = new Random(13);
        FrameInput input = lamps(300, random);
        float[] looks = input.bodies().looks();
        float[] frame = Arrays.copyOf(input.view().frame(), Layout.DISC);
        frame[Layout.EMITTER_TABLE] += Layout.DISC;
        frame[Layout.LIGHT_TREE] += Layout.DISC;
        try (HelperRun run = new HelperRun("lightTree", device, ITEMS, 7, 3, Layout.DISC + looks.length, 1, 1)) {
            put(run.first, 0, concat(frame, looks));
            for (int item = 0; item < ITEMS; item++) {
                float[] point = floats(spread(random, 9), spread(random, 2), spread(random, 9));
                put(run.input, item, concat(concat(point, direction(random)), floats(random.nextFloat())));
            }
            requireNear(run, 1e-4, ITEMS / 500);
        }
    }

    private static FrameInput lamps(int count, Random random) {
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Vector3 place = new Vector3(spread(random, 9), spread(random, 2), spread(random, 9));
            lights.add(Light.of(place, 0.01 + random.nextDouble(), new Rgb(1, 1, 1))
                    .withStrength(random.nextDouble()));
        }
        Scene scene = Scene.under(Path.of("none")).withLights(new Lights(lights));
        return World.of(
                        scene.withRendering(scene.rendering().withIntegrator(Integrator.PATH)),
                        SceneImages.of(new Skybox(1, 1, new float[] {1, 1, 1})))
                .snapshot();
    }

    /** No, one, a few and more candidates than a point's list holds; few and many samples. */
    @ParameterizedTest(name = "shadow on {0}")
    @MethodSource("devices")
    void softShadowsAreTheSameOnTheDevice(TornadoDevice device) throws TornadoExecutionPlanException {
        try (HelperRun run = new HelperRun(
                "shadow",
                device,
                ITEMS / 10,
                8,
                1,
                Layout.DISC + 2 * MOST_SAMPLES,
                Layout.PLACE_STRIDE * MANY_BODIES + Layout.spheresLength(MANY_BODIES - Layout.FIRST_SPHERE),
                Layout.LOOK_STRIDE * MANY_BODIES)) {
            Random random = new Random(11);
            fillTransmissions(run.third, random);
            for (int bodies : new int[] {2, 3, 8, BODIES, MANY_BODIES}) {
                float[] places = new float[Layout.PLACE_STRIDE * bodies];
                for (int samples : new int[] {1, 7, 64, MOST_SAMPLES}) {
                    fillSunflower(run.first, samples);
                    run.first[Layout.ROOT] = SphereHierarchy.root(bodies, bodies, 0);
                    run.first[Layout.SHADOW_ROOT] = run.first[Layout.ROOT];
                    fillBodies(places, random);
                    put(places, 1, OUT_OF_THE_WAY);
                    put(run.second, 0, SphereHierarchy.of(places, bodies, new int[0], 1 + random.nextInt(bodies)));
                    for (int item = 0; item < ITEMS / 10; item++) {
                        put(run.input, item, shadowedPoint(bodies, random));
                    }
                    // A sample at a sphere's rim may fall on either side, at a few points only.
                    requireNear(run, 1e-6, ITEMS / 10 / 100);
                }
            }
        }
    }

    @ParameterizedTest(name = "meshes on {0}")
    @MethodSource("devices")
    void meshesAreTheSameOnTheDevice(TornadoDevice device) throws TornadoExecutionPlanException {
        requireMeshesNear("mesh", device, ITEMS, HelperKernels.MESH_OUTPUTS, 1e-3);
    }

    /** One of the meshes is glass. */
    @ParameterizedTest(name = "shadows of meshes on {0}")
    @MethodSource("devices")
    void meshesShadowsAreTheSameOnTheDevice(TornadoDevice device) throws TornadoExecutionPlanException {
        requireMeshesNear("meshShadow", device, ITEMS / 4, HelperKernels.MESH_SHADOW_OUTPUTS, 1e-6);
    }

    /** Three instances of one mesh, rotated and scaled; where a ray passes a triangle's edge, rounding decides. */
    private static void requireMeshesNear(String helper, TornadoDevice device, int items, int outputs, double tolerance)
            throws TornadoExecutionPlanException {
        Random random = new Random(12);
        Bodies bodies = meshes(random);
        int looks = Layout.DISC + 2 * HelperKernels.MESH_SAMPLES;
        int frame = looks + Layout.LOOK_STRIDE * bodies.end();
        try (HelperRun run = new HelperRun(
                helper, device, items, 7, outputs, frame, bodies.floats().length, bodies.meshes().length)) {
            fillSunflower(run.first, HelperKernels.MESH_SAMPLES);
            run.first[Layout.FIRST_MESH] = bodies.firstMesh();
            run.first[Layout.ROOT] = SphereHierarchy.root(bodies.end(), Layout.FIRST_SPHERE, 0);
            run.first[Layout.SHADOW_ROOT] = run.first[Layout.ROOT];
            run.first[Layout.INSTANCES] = bodies.instances();
            run.first[looks + Layout.LOOK_STRIDE * (Layout.FIRST_SPHERE + 1) + Layout.LOOK_TRANSMISSION] = 0.5f;
            put(run.second, 0, bodies.floats());
            put(run.second, 0, floats(2, 5, -3, 0.5));
            put(run.second, 1, OUT_OF_THE_WAY);
            put(run.third, 0, bodies.meshes());
            for (int item = 0; item < items; item++) {
                put(
                        run.input,
                        item,
                        concat(
                                concat(
                                        floats(spread(random, 2), spread(random, 1), spread(random, 1)),
                                        direction(random)),
                                floats(random.nextInt(1280))));
            }
            requireNear(run, tolerance, items / 500);
        }
    }

    private static Bodies meshes(Random random) {
        List<Mesh> placed = new ArrayList<>();
        for (int i = 0; i < MESHES; i++) {
            placed.add(Mesh.of(Path.of("blob"))
                    .withPosition(new Vector3(2 * i - 2, random.nextDouble(), random.nextDouble()))
                    .withRotation(new Rotation(70, 40 * i, 10))
                    .withScale(0.5 + random.nextDouble()));
        }
        Scene scene = Scene.under(Path.of("none")).withMeshes(placed);
        MeshFile file = MeshShapes.file(MeshShapes.blob(random, 3));
        return World.of(scene, SceneImages.of(new Skybox(1, 1, new float[3])), SceneMeshes.of(scene, source -> file))
                .snapshot()
                .bodies();
    }

    private static float[] towardTriangle(int item, Random random) {
        float[] origin = floats(spread(random, 5), spread(random, 5), spread(random, 5));
        float[] corners = new float[9];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = (float) spread(random, 4);
        }
        float[] direction = new float[3];
        double b = random.nextDouble();
        double c = random.nextDouble();
        for (int axis = 0; axis < 3; axis++) {
            double place =
                    corners[axis] + b * (corners[3 + axis] - corners[axis]) + c * (corners[6 + axis] - corners[axis]);
            direction[axis] = item % 10 == 0 ? (item / 10 % 3 == axis ? 1 : 0) : (float) (place - origin[axis]);
        }
        return concat(concat(origin, direction), corners);
    }

    private static void requireNear(HelperRun run, double tolerance, int outliers) {
        float[] device = run.onDevice();
        float[] jvm = run.onJvm();
        int far = 0;
        String worst = "";
        for (int i = 0; i < jvm.length; i++) {
            assertThat(device[i])
                    .as("output %d, which the device left unwritten", i)
                    .isNotNaN();
            if (Math.abs((double) device[i] - jvm[i]) > tolerance * Math.max(1, Math.abs(jvm[i]))) {
                far++;
                worst = "output " + i + ": device " + device[i] + ", Java " + jvm[i];
            }
        }
        assertThat(far)
                .as("outputs of %d beyond the tolerance; %s", jvm.length, worst)
                .isLessThanOrEqualTo(outliers);
    }

    private static float[] input(String helper, int item, Random random) {
        return switch (helper) {
            // Includes whole numbers, where floor must not step down.
            case "floor" -> floats(item % 3 == 0 ? random.nextInt(2001) - 1000 : spread(random, 1000));
            case "inverseRoot" -> floats(item == 0 ? 0 : Math.abs(spread(random, 1e6)) + 1e-3);
            case "pow" ->
                floats(
                        item % 50 == 0 ? item / 50 % 3 : 2 * random.nextDouble(),
                        item % 3 == 0
                                ? random.nextInt(129)
                                : Math.min(128, 20 * random.nextDouble() * random.nextDouble()));
            // Axes, diagonals and the origin are frequent.
            case "atan2" ->
                item % 4 == 0
                        ? floats(random.nextInt(3) - 1, random.nextInt(3) - 1)
                        : floats(spread(random, 3), spread(random, 3));
            case "viewport" -> viewport(random);
            case "sphere" ->
                concat(
                        floats(spread(random, 9), spread(random, 9), spread(random, 9), 4 * random.nextDouble()),
                        direction(random));
            case "plane" ->
                concat(
                        floats(spread(random, 9), 20, spread(random, 9), spread(random, 9), spread(random, 9)),
                        item % 10 == 0 ? floats(1, 0, 0) : direction(random));
            case "hit" ->
                concat(
                        concat(floats(spread(random, 15), spread(random, 15), spread(random, 15)), direction(random)),
                        floats(random.nextInt(BODIES + 1) - 1, 2 + random.nextInt(BODIES - 1)));
            case "walk" ->
                concat(
                        concat(floats(spread(random, 15), spread(random, 15), spread(random, 15)), direction(random)),
                        floats(random.nextInt(BODIES + 1) - 1, BODIES));
            case "sky" ->
                concat(item % 10 == 0 ? floats(0, item % 20 == 0 ? 1 : -1, 0) : direction(random), floats(32, 16));
            case "facet" ->
                concat(
                        concat(direction(random), direction(random)),
                        floats(
                                item % 10 == 0 ? item / 10 % 2 : random.nextDouble(),
                                random.nextInt(16384),
                                random.nextInt(16384),
                                random.nextInt(65)));
            case "refraction" ->
                floats(
                        item % 10 == 0 ? item / 10 % 2 : random.nextDouble(),
                        random.nextDouble(),
                        item % 5 == 0 ? 1 : Math.pow(4, spread(random, 1)),
                        random.nextDouble());
            case "texture" ->
                floats(32 * random.nextDouble() - 0.5, item % 7 == 0 ? -0.5 : 16 * random.nextDouble() - 0.5, 32, 16);
            case "light" ->
                floats(
                        random.nextDouble(),
                        spread(random, 1),
                        random.nextDouble(),
                        item % 5 == 0 ? 128 * (item / 5 % 2) : 128 * random.nextDouble(),
                        spread(random, 1.9),
                        3 + random.nextDouble());
            // Toward a point near the triangle, sometimes along an axis.
            case "triangle" -> towardTriangle(item, random);
            case "tone" ->
                floats(
                        item % 4 == 0 ? 1000 * random.nextDouble() : random.nextDouble(),
                        Math.pow(2, spread(random, 4)),
                        item % 3,
                        item / 3 % 2);
            default -> throw new IllegalArgumentException(helper);
        };
    }

    private static float[] viewport(Random random) {
        int width = 1 + random.nextInt(4000);
        int height = 1 + random.nextInt(4000);
        return floats(width * random.nextDouble(), height * random.nextDouble(), width, height);
    }

    private static float[] shadowedPoint(int bodies, Random random) {
        float[] point = floats(spread(random, 10), spread(random, 10), spread(random, 10));
        // Sometimes straight along x, where the disc's axes are chosen differently.
        float[] axis = random.nextInt(20) == 0 ? floats(1, 0, 0) : direction(random);
        return concat(
                concat(point, floats(random.nextInt(bodies + 1) - 1)),
                concat(axis, floats(2 + 20 * random.nextDouble())));
    }

    private static void fillTables(HelperRun run, Random random) {
        if (run.second.length > 1) {
            float[] places = new float[Layout.PLACE_STRIDE * BODIES];
            fillBodies(places, random);
            put(run.first, 0, SphereHierarchy.of(places, BODIES, new int[0], MOST_IN_LEAF));
            fillTransmissions(run.second, random);
        } else if (run.first.length == Layout.INSTANCE_STRIDE) {
            put(run.first, 0, floats(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0));
        } else {
            for (int i = 0; i < run.first.length; i++) {
                run.first[i] = 4 * random.nextFloat();
            }
        }
    }

    private static void fillBodies(float[] places, Random random) {
        for (int i = 0; i < places.length; i++) {
            boolean isSize = i % Layout.PLACE_STRIDE == Layout.PLACE_SIZE;
            places[i] = isSize ? 0.1f + 2 * random.nextFloat() : (float) spread(random, 10);
        }
    }

    /** A third of the spheres is glass. */
    private static void fillTransmissions(float[] looks, Random random) {
        for (int look = Layout.LOOK_STRIDE * Layout.FIRST_SPHERE; look < looks.length; look += Layout.LOOK_STRIDE) {
            looks[look + Layout.LOOK_TRANSMISSION] = Math.max(0, 3 * random.nextFloat() - 2);
        }
    }

    private static void fillSunflower(float[] frame, int samples) {
        frame[Layout.SHADOW_SAMPLES] = samples;
        for (int i = 0; i < samples; i++) {
            double distance = Math.sqrt((double) i / samples);
            frame[Layout.DISC + 2 * i] = (float) (distance * Math.cos(i * 2.399963229728653));
            frame[Layout.DISC + 2 * i + 1] = (float) (distance * Math.sin(i * 2.399963229728653));
        }
    }

    private static float[] direction(Random random) {
        double x = random.nextGaussian();
        double y = random.nextGaussian();
        double z = random.nextGaussian();
        double length = Math.sqrt(x * x + y * y + z * z);
        return floats(x / length, y / length, z / length);
    }

    private static double spread(Random random, double reach) {
        return reach * (2 * random.nextDouble() - 1);
    }

    private static float[] floats(double... values) {
        float[] floats = new float[values.length];
        for (int i = 0; i < values.length; i++) {
            floats[i] = (float) values[i];
        }
        return floats;
    }

    private static float[] concat(float[] head, float[] tail) {
        float[] both = java.util.Arrays.copyOf(head, head.length + tail.length);
        System.arraycopy(tail, 0, both, head.length, tail.length);
        return both;
    }

    private static void put(float[] array, int item, float[] values) {
        System.arraycopy(values, 0, array, item * values.length, values.length);
    }
}
