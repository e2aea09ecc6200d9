package dev.twister.scene.format;

import dev.twister.scene.Camera;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Pour;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Random;

/** Random valid scenes over the whole ranges of the scene file, with small pictures. */
public final class WholeRangeScenes {
    /** Limit of ray-sphere tests per picture; picture sizes are reduced to it. */
    private static final double MOST_TESTS = 3e6;

    private static final int MOST_PIXELS = 2000;
    private static final int CROWD = 300;

    private static final SceneFormat FORMAT =
            new SceneFormat(Scene.VERSION, new LinkedHashMap<>(), NamedFiles.UNRESOLVED);

    /** The file used for all textures and the sky. */
    public static final Path PICTURE = Path.of("picture.png");

    private WholeRangeScenes() {}

    /** Returns the next scene, without the spheres that the pour will add. */
    public static Scene next(Random random) {
        RandomValues values = new RandomValues(random);
        Scene scene = values.of(FORMAT.scene()).withPour(Pour.DEFAULT).withTracks(List.of());
        if (random.nextInt(16) == 0) {
            List<Sphere> spheres = new ArrayList<>();
            for (int i = 0; i < CROWD; i++) {
                spheres.add(values.of(FORMAT.sphere()));
            }
            scene = scene.withSpheres(spheres);
        }
        if (random.nextInt(3) > 0) {
            scene = scene.withCamera(lookingAtABody(scene, random));
        }
        return scene.withRendering(affordable(scene, random));
    }

    private static Camera lookingAtABody(Scene scene, Random random) {
        List<Vector3> bodies = new ArrayList<>();
        bodies.add(scene.lights().first().position());
        bodies.add(new Vector3(0, scene.ground().height(), 0));
        scene.spheres().forEach(sphere -> bodies.add(sphere.position()));
        Vector3 body = bodies.get(random.nextInt(bodies.size()));
        Vector3 from = scene.camera().position();
        double x = body.x() - from.x();
        double z = body.z() - from.z();
        return scene.camera()
                .withYawDegrees(Math.toDegrees(Math.atan2(x, z)))
                .withPitchDegrees(Math.toDegrees(Math.atan2(from.y() - body.y(), Math.hypot(x, z))));
    }

    private static Rendering affordable(Scene scene, Random random) {
        Rendering settings = scene.rendering();
        int bounces = Math.min(settings.bounces(), 8);
        int samples = Math.min(settings.samplesPerPixel(), 4);
        int shadows = Math.min(settings.shadowSamples(), 2 + random.nextInt(100));
        double testsAPixel = samples * (bounces + 1.0) * (2 + scene.spheres().size()) * (shadows + 1);
        int pixels = (int) Math.clamp(MOST_TESTS / testsAPixel, 64, MOST_PIXELS);
        int width = 1 + random.nextInt(random.nextBoolean() ? 100 : pixels);
        return settings.withSize(width, 1 + pixels / width)
                .withShadowSamples(shadows)
                .withBounces(bounces)
                .withSamplesPerPixel(samples);
    }
}
