package dev.twister.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;

class SceneFilePropertyTest {
    // jqwik knows no temporary folders; the build's own is never committed.
    private static final Path FOLDER = Path.of("target", "scene-properties").toAbsolutePath();
    private static final String ALPHABET = "{}[]:,\"\\.0123456789eE+-truefalsnl \n\u0000";

    @Property(tries = 1000)
    void spoiltBytesAreReadOrRefusedInOneLine(@ForAll long seed, @ForAll @IntRange(min = 1, max = 6) int changes) {
        byte[] bytes = spoilt(new Random(seed), changes);
        Path file = SampleScene.put(FOLDER, bytes);
        try {
            SceneReader.read(file);
        } catch (SceneException refusal) {
            assertThat(refusal.getMessage())
                    .contains("scene.json")
                    .hasSizeLessThan(1000)
                    .matches(message -> message.chars().noneMatch(Character::isISOControl));
        }
    }

    @Property(tries = 200)
    void whatIsWrittenReadsBackEqual(@ForAll("scenes") Scene scene) {
        Path file = SampleScene.put(FOLDER, "").resolveSibling("written.json");

        SceneWriter.write(scene, file);

        assertThat(SceneReader.read(file)).isEqualTo(scene);
    }

    private static byte[] spoilt(Random random, int changes) {
        byte[] bytes = SampleScene.TEXT.getBytes(StandardCharsets.UTF_8);
        for (int i = 0; i < changes && bytes.length > 0; i++) {
            int place = random.nextInt(bytes.length);
            switch (random.nextInt(5)) {
                case 0 -> bytes[place] = (byte) random.nextInt(256);
                case 1 -> bytes[place] = (byte) ALPHABET.charAt(random.nextInt(ALPHABET.length()));
                case 2 -> bytes = Arrays.copyOf(bytes, Math.max(1, place));
                case 3 -> bytes = without(bytes, place, Math.min(bytes.length, place + random.nextInt(20)));
                default -> bytes = doubled(bytes, place, Math.min(bytes.length, place + random.nextInt(80)));
            }
        }
        return bytes;
    }

    private static byte[] without(byte[] bytes, int from, int to) {
        byte[] rest = Arrays.copyOf(bytes, bytes.length - (to - from));
        System.arraycopy(bytes, to, rest, from, bytes.length - to);
        return rest;
    }

    private static byte[] doubled(byte[] bytes, int from, int to) {
        byte[] longer = Arrays.copyOf(bytes, bytes.length + (to - from));
        System.arraycopy(bytes, from, longer, to, bytes.length - from);
        return longer;
    }

    @Provide
    Arbitrary<Scene> scenes() {
        Arbitrary<String> texts = Arbitraries.strings()
                .ofMaxLength(60)
                .filter(text -> text.chars().noneMatch(Character::isISOControl));
        return Combinators.combine(
                        texts,
                        texts,
                        cameras(),
                        lights(),
                        planes(),
                        spheres().list().ofMaxSize(8),
                        number(0, 1),
                        Combinators.combine(settings(), physics(), pours().optional())
                                .as(Motion::new))
                .as((name, description, camera, light, plane, spheres, ambient, motion) -> new Scene(
                        name,
                        description,
                        camera,
                        light,
                        plane,
                        spheres,
                        FOLDER.resolve("sky.hdr"),
                        ambient,
                        motion.settings(),
                        motion.physics(),
                        motion.pour()));
    }

    /** Three parts in one, because jqwik combines eight at most. */
    private record Motion(RenderSettings settings, Physics physics, Optional<Pour> pour) {}

    private static Arbitrary<Physics> physics() {
        Arbitrary<Vector3> gravities = Combinators.combine(
                        number(-1000, 1000), number(-1000, 1000), number(-1000, 1000))
                .as(Vector3::new);
        Arbitrary<Boolean> flags = Arbitraries.of(List.of(true, false));
        return Combinators.combine(gravities, number(0, 1), number(0, 10), number(0, 100), flags, flags)
                .as(Physics::new);
    }

    // Slow enough for the narrowest spout.
    private static Arbitrary<Pour> pours() {
        return Combinators.combine(
                        Arbitraries.integers().between(1, 499_992),
                        number(0.001, 0.4),
                        positions(),
                        number(1e-6, 1e6),
                        number(1, 100),
                        number(1e-6, 1),
                        Arbitraries.of(Palette.class),
                        Arbitraries.integers().between(0, Integer.MAX_VALUE))
                .as((count, rate, position, width, speed, radius, palette, seed) -> new Pour(
                        count, rate, position, width, speed, radius, 1.25 * radius, palette, seed % 129, seed));
    }

    private static Arbitrary<Camera> cameras() {
        return Combinators.combine(positions(), number(-1e6, 1e6), number(-90, 90), number(1, 179))
                .as(Camera::new);
    }

    private static Arbitrary<Light> lights() {
        return Combinators.combine(positions(), number(1e-6, 1e6), colors(1e6)).as(Light::new);
    }

    private static Arbitrary<Plane> planes() {
        return Combinators.combine(number(1e-6, 1e6), number(-1e6, 1e6), colors(1), colors(1), number(0, 128))
                .as(Plane::new);
    }

    private static Arbitrary<Sphere> spheres() {
        return Combinators.combine(positions(), number(1e-6, 1e6), colors(1), number(0, 128))
                .as(Sphere::new);
    }

    private static Arbitrary<RenderSettings> settings() {
        return Combinators.combine(
                        Arbitraries.integers().between(1, 16384),
                        Arbitraries.integers().between(1, 16384),
                        Arbitraries.integers().between(1, 1024),
                        Arbitraries.integers().between(0, 64),
                        Arbitraries.integers().between(1, 1024),
                        number(-20, 20),
                        Arbitraries.of(ToneMap.class),
                        Arbitraries.of(List.of(true, false)))
                .as(RenderSettings::new);
    }

    private static Arbitrary<Vector3> positions() {
        return Combinators.combine(number(-1e6, 1e6), number(-1e6, 1e6), number(-1e6, 1e6))
                .as(Vector3::new);
    }

    private static Arbitrary<Rgb> colors(double max) {
        return Combinators.combine(number(0, max), number(0, max), number(0, max))
                .as(Rgb::new);
    }

    // Of many digits, as arithmetic leaves them, and with both ends.
    private static Arbitrary<Double> number(double min, double max) {
        return Arbitraries.oneOf(
                Arbitraries.longs().map(bits -> min + (max - min) * ((bits >>> 11) * 0x1.0p-53)),
                Arbitraries.of(min, max));
    }
}
