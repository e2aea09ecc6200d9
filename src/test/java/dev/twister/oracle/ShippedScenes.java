package dev.twister.oracle;

import dev.twister.scene.Integrator;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The scenes in the folder {@code scenes}, reduced for the oracle. */
public final class ShippedScenes {
    private static final Path FOLDER = Path.of("scenes");

    /** Scenes with more spheres than this are rendered smaller. */
    private static final int MANY_SPHERES = 1000;

    /** Scenes of traced paths with this many meshes or more have thousands of triangles. */
    private static final int MANY_MESHES = 20;

    private static final int FEW_SAMPLES = 4;

    private static final boolean ALWAYS_LARGE = "large".equals(System.getProperty("twister.oracle"));

    private ShippedScenes() {}

    /** File names without {@code .json}. */
    public static List<String> names() {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(".json") && !name.endsWith(".schema.json"))
                    .map(name -> name.substring(0, name.length() - ".json".length()))
                    .sorted()
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Those of {@link #oracleNames} that do not take it seconds; all with {@code -Dtwister.oracle=large}. */
    static List<String> quickOracleNames() {
        return oracleNames().stream()
                .filter(name -> ALWAYS_LARGE || !List.of("atrium", "stage").contains(name))
                .toList();
    }

    /** Those for the oracle: it has neither height maps nor maps on spheres, and the street's lamps take it minutes. */
    static List<String> oracleNames() {
        return names().stream()
                .filter(name -> !List.of("maps", "street").contains(name))
                .toList();
    }

    /** The shipped scene in a picture of 320 x 180; of few samples if paths are traced. */
    public static LitScene small(String name) {
        LitScene shipped = read(name);
        Rendering settings = shipped.scene().rendering().withSize(320, 180);
        return settings.integrator() == Integrator.WHITTED
                ? with(shipped, settings)
                : with(shipped, settings.withSamplesPerPixel(FEW_SAMPLES));
    }

    /**
     * A version that the oracle renders quickly: 160 x 90 pixels with at most 48 shadow samples, thousands of spheres
     * at 64 x 36 with 4, thousands of triangles at 32 x 18 with 1 and 2 bounces. With {@code -Dtwister.oracle=large},
     * spheres are seen at 320 x 180 and 96 x 54. No paths are traced.
     */
    public static LitScene quick(String name) {
        return reduced(name, ALWAYS_LARGE);
    }

    /** What {@link #quick} gives with {@code -Dtwister.oracle=large}. */
    static LitScene large(String name) {
        return reduced(name, true);
    }

    private static LitScene reduced(String name, boolean large) {
        LitScene small = small(name);
        Rendering settings = small.scene().rendering();
        int meshes = small.scene().meshes().size();
        if (settings.integrator() == Integrator.PATH && meshes < MANY_MESHES) {
            Rendering simple = settings.withIntegrator(Integrator.WHITTED);
            return with(small, simple.withSamplesPerPixel(1).withBounces(3).withSize(96, 54));
        }
        if (meshes > 0) {
            return with(
                    small,
                    settings.withIntegrator(Integrator.WHITTED)
                            .withSize(32, 18)
                            .withShadowSamples(1)
                            .withBounces(2));
        }
        return small.scene().spheres().size() > MANY_SPHERES
                ? with(small, (large ? settings.withSize(96, 54) : settings.withSize(64, 36)).withShadowSamples(4))
                : with(
                        small,
                        (large ? settings : settings.withSize(160, 90))
                                .withShadowSamples(Math.min(settings.shadowSamples(), 48)));
    }

    private static LitScene read(String name) {
        Scene scene = SceneReader.read(FOLDER.resolve(name + ".json"));
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        return new LitScene(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
    }

    private static LitScene with(LitScene shipped, Rendering settings) {
        return new LitScene(shipped.scene().withRendering(settings), shipped.images(), shipped.meshes());
    }
}
