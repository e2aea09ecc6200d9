package dev.twister.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import net.jqwik.api.Arbitrary;
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
        return Values.of(SceneFormat.SCENE)
                .map(scene -> scene.pour()
                        .map(pour ->
                                scene.withPour(fitting(pour, scene.spheres().size())))
                        .orElse(scene))
                .map(scene -> scene.withSkybox(FOLDER.resolve("sky.hdr")));
    }

    // The rules that a pour's fields have to keep together.
    private static Pour fitting(Pour pour, int placed) {
        double radius = Math.min(pour.minRadius(), 1);
        Pour narrow = pour.withRadii(radius, 1.25 * radius)
                .withSpeed(Math.max(pour.speed(), 1))
                .withCount(Math.min(pour.count(), SceneLimits.MAX_SPHERES - placed));
        return narrow.withRate(Math.min(narrow.rate(), narrow.maxRate()));
    }
}
