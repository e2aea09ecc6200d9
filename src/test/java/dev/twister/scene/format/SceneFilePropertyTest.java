package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraView;
import dev.twister.scene.Easing;
import dev.twister.scene.Geometry;
import dev.twister.scene.Ground;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Shape;
import dev.twister.scene.Sky;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Triangles;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Alpha;
import dev.twister.scene.material.Emission;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.SceneLimits;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.SequencedMap;
import java.util.stream.IntStream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;

class SceneFilePropertyTest {
    // jqwik has no temporary folders; the build folder is never committed.
    private static final Path FOLDER = Path.of("target", "scene-properties").toAbsolutePath();
    private static final String ALPHABET = "{}[]:,\"\\.0123456789eE+-truefalsnl \n\u0000";

    @Property(tries = 1000)
    void spoiltBytesAreReadOrRefusedInOneLineEach(@ForAll long seed, @ForAll @IntRange(min = 1, max = 6) int changes) {
        Random random = new Random(seed);
        byte[] bytes = spoilt(random, random.nextBoolean() ? SampleScene.TEXT : SampleScene.MATERIALS, changes);
        Path file = SampleScene.put(FOLDER, bytes);
        try {
            SceneReader.read(file);
        } catch (SceneException refusal) {
            assertThat(refusal.getMessage().lines())
                    .allSatisfy(line -> assertThat(line)
                            .contains("scene.json")
                            .hasSizeLessThan(1000)
                            .matches(message -> message.chars().noneMatch(Character::isISOControl)));
        }
    }

    @Property(tries = 60, edgeCases = EdgeCasesMode.NONE)
    void whatIsWrittenReadsBackEqualAndIsWrittenAlike(@ForAll("scenes") Scene scene) throws IOException {
        Path file = SampleScene.put(FOLDER, "").resolveSibling("written.json");

        SceneWriter.write(scene, file);
        byte[] bytes = Files.readAllBytes(file);
        Scene read = SceneReader.read(file);
        SceneWriter.write(read, file);

        assertThat(read).isEqualTo(scene);
        assertThat(file).hasBinaryContent(bytes);
    }

    private static byte[] spoilt(Random random, String text, int changes) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
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
        return Arbitraries.integers()
                .between(1, Scene.VERSION)
                .flatMap(version -> version == 1
                        ? scenes(version, new LinkedHashMap<>())
                        : Values.of(format(version, new LinkedHashMap<>()).materials())
                                .flatMap(materials -> scenes(version, materials)));
    }

    private static Arbitrary<Scene> scenes(int version, SequencedMap<String, Material> materials) {
        return Values.of(format(version, materials).scene())
                .map(scene -> scene.withMaterials(materials))
                .map(scene -> scene.withGround(scene.ground()
                        .withMaterial(opaque(scene.ground().material()).withEmission(Emission.NONE))))
                .map(scene -> scene.withSpheres(scene.spheres().stream()
                        .map(sphere -> sphere.withMaterial(opaque(sphere.material())))
                        .toList()))
                .map(scene -> scene.withLights(withOneSeen(scene.lights())))
                .map(scene -> scene.withCamera(risingTimes(scene.camera())))
                .map(scene -> scene.withViews(withOwnNames(scene.views())))
                .map(scene -> scene.pour()
                        .map(pour -> scene.withPour(fitting(
                                pour.withMaterial(opaque(pour.material())),
                                scene.spheres().size())))
                        .orElse(scene))
                .map(SceneFilePropertyTest::withPossibleTracks)
                .map(SceneFilePropertyTest::withFiles);
    }

    private static Lights withOneSeen(Lights lights) {
        Light first = lights.first();
        return lights.with(0, first.withTag(first.tag().withHidden(false)));
    }

    private static Scene withPossibleTracks(Scene scene) {
        return scene.tracks().isEmpty()
                ? scene
                : scene.withTracks(List.of(scene.tracks()
                        .getFirst()
                        .withTarget(TrackTarget.RENDERING)
                        .withProperty("exposure")
                        .withKeyframes(List.of(Keyframe.of(0.5, -1).withEasing(Easing.HOLD), Keyframe.of(1, 0.25)))));
    }

    private static SceneFormat format(int version, SequencedMap<String, Material> materials) {
        return new SceneFormat(version, materials, NamedFiles.UNRESOLVED);
    }

    private static Scene withFiles(Scene scene) {
        SequencedMap<String, Material> materials = new LinkedHashMap<>();
        scene.materials().forEach((name, material) -> materials.put(name, withFiles(material)));
        Ground plane = scene.ground();
        Path sky = scene.sky().file();
        Scene there = scene.withSky(scene.sky().withFile(sky.equals(Sky.PLAIN) ? sky : FOLDER.resolve(sky)))
                .withMaterials(materials)
                .withGround(plane.withMaterial(withFiles(plane.material())))
                .withSpheres(scene.spheres().stream()
                        .map(sphere -> sphere.withMaterial(withFiles(sphere.material())))
                        .toList())
                .withMeshes(scene.meshes().stream()
                        .map(mesh -> mesh.withGeometry(possible(mesh.geometry())))
                        .map(mesh -> mesh.material()
                                .map(SceneFilePropertyTest::withFiles)
                                .map(mesh::withMaterial)
                                .orElse(mesh))
                        .toList());
        return there.pour()
                .map(pour -> there.withPour(pour.withMaterial(withFiles(pour.material()))))
                .orElse(there);
    }

    // With the file in the folder, or a size that the kind of shape can have.
    private static Geometry possible(Geometry geometry) {
        return switch (geometry) {
            case Geometry.OfFile(Path path, String scene) -> new Geometry.OfFile(FOLDER.resolve(path), scene);
            case Shape shape -> {
                Vector3 size = shape.size().map(side -> Math.max(side, 1e-3));
                double height = shape.kind() == Shape.Kind.TORUS ? Math.min(size.y(), size.x() / 4) : size.y();
                double depth = shape.kind() == Shape.Kind.QUAD ? 0 : size.z();
                yield new Shape(shape.kind(), new Vector3(size.x(), height, depth));
            }
            case Triangles _ -> new Geometry.OfFile(FOLDER.resolve("made.ply"));
        };
    }

    private static Material opaque(Material material) {
        return material.withAlpha(Alpha.OPAQUE);
    }

    private static Material withFiles(Material material) {
        Material there = material;
        for (dev.twister.scene.property.Property<Material, Optional<Path>> image : MaterialProperties.IMAGES) {
            Optional<Path> file = image.getter().apply(there).map(FOLDER::resolve);
            there = file.isPresent() ? image.wither().apply(there, file) : there;
        }
        return there;
    }

    private static Camera risingTimes(Camera camera) {
        return camera.withKeyframes(IntStream.range(0, camera.keyframes().size())
                .mapToObj(index -> camera.keyframes().get(index).withSeconds(index))
                .toList());
    }

    private static List<CameraView> withOwnNames(List<CameraView> views) {
        return IntStream.range(0, views.size())
                .mapToObj(index -> views.get(index).withName("View " + index))
                .toList();
    }

    // Constraints between the fields of a pour.
    private static Pour fitting(Pour pour, int placed) {
        double radius = Math.min(pour.minRadius(), 1);
        Pour narrow = pour.withRadii(radius, 1.25 * radius)
                .withSpeed(Math.max(pour.speed(), 1))
                .withCount(Math.min(pour.count(), SceneLimits.MAX_SPHERES - placed));
        return narrow.withRate(Math.min(narrow.rate(), narrow.maxRate()));
    }
}
