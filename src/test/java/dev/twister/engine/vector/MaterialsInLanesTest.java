package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import dev.twister.image.Frame;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.PictureDifference;
import dev.twister.oracle.RandomScenes;
import dev.twister.scene.Camera;
import dev.twister.scene.Integrator;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.TexturePlaces;
import dev.twister.sky.Skybox;
import dev.twister.sky.TextureImage;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Glass, metals, rough surfaces, textures, the lens and traced paths in lanes equal the scalar kernel's, in random
 * scenes and also with cameras inside glass.
 */
final class MaterialsInLanesTest {
    private static final int NEVER_WALK = Integer.MAX_VALUE;
    private static final int SCENES = WidthLoader.ALL ? 30 : 10;
    private static final Path FILE = Path.of("texture.png").toAbsolutePath();

    /** Material kinds beyond color and reflectivity. */
    private enum Kind {
        TEXTURES,
        ROUGH,
        GLASS,
        METALS,
        LENS,
        ALL,
        /** All of them, by path tracing. */
        PATHS;

        boolean has(Kind part) {
            return this == part || this == ALL || this == PATHS;
        }
    }

    static Stream<Object[]> widthsAndKinds() {
        return WidthLoader.WIDTHS.stream()
                .flatMap(bits -> Stream.of(Kind.values()).map(kind -> new Object[] {bits, kind}));
    }

    @ParameterizedTest(name = "{1} at {0} bits")
    @MethodSource("widthsAndKinds")
    void randomScenesAreTheSame(int bits, Object kind) {
        Random random = new Random(20261125);
        int pixels = 0;
        int different = 0;
        try (Engine few = WidthLoader.openForCrowds(bits, 2, NEVER_WALK);
                Engine crowd = WidthLoader.openForCrowds(bits, 2, 0);
                Engine sequential = Engines.open(JvmEngines.SEQUENTIAL)) {
            for (int count = 0; count < SCENES; count++) {
                FrameInput input = scene(random, (Kind) kind);
                int[] expected = pixels(sequential, input);
                for (Engine engine : List.of(few, crowd)) {
                    PictureDifference difference = PictureDifference.between(pixels(engine, input), expected);
                    pixels += difference.pixels();
                    different += difference.differing().length;
                }
            }
        }
        assertThat(different).isLessThanOrEqualTo(pixels / PictureDifference.PIXELS_AN_ODD_ONE);
    }

    private static FrameInput scene(Random random, Kind kind) {
        LitScene lit = RandomScenes.scene(random, random.nextInt(6));
        Scene plain = lit.scene();
        List<Sphere> spheres = new ArrayList<>();
        for (Sphere sphere : plain.spheres()) {
            spheres.add(sphere.withMaterial(material(sphere.material(), random, kind)));
        }
        if (!spheres.isEmpty()) {
            addInsideAndBeside(spheres, spheres.getFirst());
        }
        Camera camera = plain.camera();
        if (kind.has(Kind.LENS)) {
            camera = camera.withAperture(0.3 * random.nextDouble()).withFocusDistance(1 + 9 * random.nextDouble());
        }
        Scene scene = plain.withCamera(camera)
                .withSpheres(spheres)
                .withGround(plain.ground().withMaterial(material(plain.ground().material(), random, kind)))
                .withRendering(
                        plain.rendering().withIntegrator(kind == Kind.PATHS ? Integrator.PATH : Integrator.WHITTED));
        return World.of(scene, new SceneImages(lit.sky(), textures(scene, random)))
                .snapshot();
    }

    /** Adds one sphere of the same material inside the first and one that touches it. */
    private static void addInsideAndBeside(List<Sphere> spheres, Sphere first) {
        Vector3 center = first.position();
        double radius = first.radius();
        Rgb color = new Rgb(1, 0.9, 0.8);
        Vector3 beside = new Vector3(center.x() + 2 * radius, center.y(), center.z());
        spheres.add(Sphere.of(center, 0.6 * radius, color, 4).withMaterial(first.material()));
        spheres.add(Sphere.of(beside, radius, color, 4).withMaterial(first.material()));
    }

    private static Material material(Material plain, Random random, Kind kind) {
        Material material = plain;
        if (random.nextBoolean() && kind.has(Kind.TEXTURES)) {
            material = material.withTexture(FILE);
        }
        if (random.nextBoolean() && kind.has(Kind.ROUGH)) {
            material = material.withRoughness(random.nextInt(4) == 0 ? 1 : random.nextDouble());
        }
        if (random.nextBoolean() && kind.has(Kind.GLASS)) {
            material = material.withTransmission(random.nextBoolean() ? 1 : random.nextDouble())
                    .withIor(random.nextInt(5) == 0 ? 1 : 1 + 3 * random.nextDouble());
        }
        if (random.nextBoolean() && kind.has(Kind.METALS)) {
            material = material.withMetallic(random.nextBoolean() ? 1 : random.nextDouble());
        }
        return material;
    }

    private static Map<Path, TextureImage> textures(Scene scene, Random random) {
        float[] texels = new float[3 * 7 * 5];
        for (int i = 0; i < texels.length; i++) {
            texels[i] = random.nextFloat();
        }
        return TexturePlaces.of(scene).isEmpty() ? Map.of() : Map.of(FILE, new Skybox(7, 5, texels));
    }

    private static int[] pixels(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        engine.render(input, frame);
        return frame.argb();
    }
}
