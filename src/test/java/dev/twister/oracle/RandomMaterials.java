package dev.twister.oracle;

import dev.twister.scene.Camera;
import dev.twister.scene.Material;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.material.Attenuation;
import dev.twister.scene.material.Emission;
import dev.twister.sky.PackedImage;
import dev.twister.sky.Skybox;
import dev.twister.sky.TextureImage;
import dev.twister.world.SceneImages;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;

/**
 * {@link RandomScenes} with glass, rough surfaces and textures, through a lens: nested, separate, touching and
 * overlapping glass, also around the camera and halfway in the ground, indices of 1 and 4, crowds, and the extremes of
 * roughness and transmission.
 */
public final class RandomMaterials {
    /** Limit of the oracle's work per picture: rays, including branches, times bodies times shadow rays. */
    private static final double MOST_TESTS = 4e6;

    private static final List<Path> TEXTURES = List.of(Path.of("a.png"), Path.of("b.png"));

    private RandomMaterials() {}

    /** Scenes with a number of bounces in this range. */
    public static Arbitrary<LitScene> ofBounces(int least, int most) {
        return Arbitraries.randomValue(random -> scene(random, least + random.nextInt(most - least + 1)));
    }

    /** Any scene, from one source of randomness. */
    public static LitScene scene(Random random, int bounces) {
        LitScene plain = RandomScenes.scene(random, bounces);
        Scene scene = plain.scene();
        List<Sphere> spheres = new ArrayList<>();
        for (Sphere sphere : scene.spheres()) {
            spheres.add(sphere.withMaterial(material(random, sphere.material())));
            if (random.nextInt(4) == 0) {
                spheres.add(inside(random, sphere));
            }
        }
        if (random.nextInt(6) == 0) {
            addCrowd(random, spheres);
        }
        Map<Path, TextureImage> textures = new HashMap<>();
        TEXTURES.forEach(file -> textures.put(file, texture(random)));
        return new LitScene(
                scene.withSpheres(spheres)
                        .withGround(scene.ground()
                                .withMaterial(material(random, scene.ground().material())))
                        .withCamera(camera(random, scene.camera(), spheres))
                        .withRendering(settings(scene.rendering(), spheres.size())),
                new SceneImages(plain.sky(), textures));
    }

    public static Material material(Random random, Material plain) {
        Material material = switch (random.nextInt(4)) {
            case 0 -> plain;
            case 1 -> glass(random, plain).withTransmission(1).withReflectivity(0);
            default -> glass(random, plain).withTransmission(RandomScenes.extremeOr(random, 0, 1, random.nextDouble()));
        };
        double roughness = random.nextBoolean() ? 0 : RandomScenes.extremeOr(random, 0, 1, random.nextDouble());
        Material rough = material.withRoughness(roughness);
        return random.nextInt(4) == 0
                ? rough.withTexture(TEXTURES.get(random.nextInt(TEXTURES.size())))
                : rough.withoutTexture();
    }

    /** The same scene, some of whose spheres are metals, and some emit light. */
    static LitScene tinted(LitScene plain, Random random) {
        List<Sphere> spheres = plain.scene().spheres().stream()
                .map(sphere -> sphere.withMaterial(tinted(sphere.material(), random)))
                .toList();
        return new LitScene(plain.scene().withSpheres(spheres), plain.images());
    }

    private static Material tinted(Material plain, Random random) {
        return switch (random.nextInt(5)) {
            case 0 -> plain.withMetallic(RandomScenes.extremeOr(random, 0, 1, random.nextDouble()));
            case 1 -> plain.withEmission(Emission.NONE.withColor(new Rgb(random.nextFloat(), random.nextFloat(), 0.5)));
            case 2 -> plain.withThinWalled(true);
            case 3 ->
                plain.withAttenuation(new Attenuation(
                        new Rgb(random.nextFloat(), 0.8, 1), Optional.of(RandomScenes.between(random, 0.2, 4))));
            default -> plain;
        };
    }

    private static Material glass(Random random, Material plain) {
        return plain.withIor(RandomScenes.extremeOr(random, 1, 4, RandomScenes.between(random, 1, 2.5)));
    }

    /** At the sphere's center, touching it from inside, or across its surface. */
    private static Sphere inside(Random random, Sphere outer) {
        double radius = outer.radius() * RandomScenes.between(random, 0.2, 0.9);
        double distance = switch (random.nextInt(3)) {
            case 0 -> 0;
            case 1 -> outer.radius() - radius;
            default -> outer.radius() * random.nextDouble();
        };
        Vector3 center = outer.position();
        return outer.withMaterial(material(random, outer.material()))
                .withRadius(radius)
                .withPosition(
                        random.nextBoolean()
                                ? new Vector3(center.x(), center.y() + distance, center.z())
                                : new Vector3(center.x() - distance, center.y(), center.z()));
    }

    private static void addCrowd(Random random, List<Sphere> spheres) {
        for (int i = 0; i < 100; i++) {
            Sphere sphere = Sphere.of(
                    new Vector3(
                            RandomScenes.between(random, -5, 5),
                            RandomScenes.between(random, -1, 6),
                            RandomScenes.between(random, -5, 5)),
                    RandomScenes.between(random, 0.1, 0.8),
                    RandomScenes.albedo(random),
                    RandomScenes.reflectivity(random));
            spheres.add(sphere.withMaterial(material(random, sphere.material())));
        }
    }

    private static Camera camera(Random random, Camera plain, List<Sphere> spheres) {
        Camera placed = spheres.isEmpty() || random.nextInt(4) > 0
                ? plain
                : plain.withPosition(RandomScenes.near(random, spheres.getFirst()));
        return random.nextInt(3) > 0
                ? placed
                : placed.withAperture(RandomScenes.extremeOr(random, 1e-3, 1, RandomScenes.between(random, 0, 0.3)))
                        .withFocusDistance(RandomScenes.between(random, 0.3, 15));
    }

    /** Reduces the number of pixels where there are many spheres or triangles. */
    public static Rendering settings(Rendering plain, int spheres) {
        int shadowSamples = Math.min(plain.shadowSamples(), 40);
        double branches = Math.min(1 << plain.bounces(), 60);
        double testsAPixel = plain.samplesPerPixel() * branches * (2 + spheres) * (shadowSamples + 1);
        double scale = Math.sqrt(Math.min(1, MOST_TESTS / testsAPixel / (plain.width() * plain.height())));
        return plain.withShadowSamples(shadowSamples)
                .withSize(Math.max(1, (int) (scale * plain.width())), Math.max(1, (int) (scale * plain.height())));
    }

    private static TextureImage texture(Random random) {
        int width = 1 + random.nextInt(6);
        int height = 1 + random.nextInt(6);
        return random.nextBoolean() ? floats(random, width, height) : packed(random, width, height);
    }

    private static PackedImage packed(Random random, int width, int height) {
        float[] linear = new float[PackedImage.VALUES];
        for (int value = 0; value < linear.length; value++) {
            linear[value] = (float) RandomScenes.extremeOr(random, 0, 1, random.nextDouble());
        }
        return new PackedImage(width, height, random.ints((long) width * height).toArray(), linear, true);
    }

    private static Skybox floats(Random random, int width, int height) {
        float[] texels = new float[3 * width * height];
        for (int i = 0; i < texels.length; i++) {
            texels[i] = (float) RandomScenes.extremeOr(random, 0, 1, random.nextDouble());
        }
        return new Skybox(width, height, texels);
    }
}
