import dev.twister.RenderedPicture;
import dev.twister.SceneBuilder;
import dev.twister.Twister;
import dev.twister.scene.Camera;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** Checks a lamp, and shows it: {@code java -cp CLASSPATH CheckLight.java [solution]}. */
final class CheckLight {
    private static final Path PICTURE = Path.of("light.png");
    private static final Vector3 CENTER = new Vector3(-2, 5, -1);
    private static final double WIDTH = 2;
    private static final double DEPTH = 1;
    private static final int ACROSS = 6;
    private static final int ALONG = 3;

    private CheckLight() {}

    public static void main(String[] arguments) throws IOException {
        System.exit(run(arguments));
    }

    static int run(String... arguments) throws IOException {
        List<Light> lamp = Checks.isSolution(arguments)
                ? LightSolution.lamp(CENTER, WIDTH, DEPTH, ACROSS, ALONG)
                : LightAttempt.lamp(CENTER, WIDTH, DEPTH, ACROSS, ALONG);
        Checks checks = new Checks();
        checks.that(lamp.size() == ACROSS * ALONG, "it has " + lamp.size() + " lights, but the grid has 18 cells");
        checks.near("the sum of the shares", sum(lamp, Light::share), 1, 1e-6);
        checks.near("the mean x", sum(lamp, light -> light.position().x()) / lamp.size(), CENTER.x(), 1e-6);
        checks.near("the mean z", sum(lamp, light -> light.position().z()) / lamp.size(), CENTER.z(), 1e-6);
        checks.near("the smallest x", least(lamp, light -> light.position().x()), CENTER.x() - 5 / 6d, 1e-6);
        checks.near("the largest x", -least(lamp, light -> -light.position().x()), CENTER.x() + 5 / 6d, 1e-6);
        checks.near("the smallest z", least(lamp, light -> light.position().z()), CENTER.z() - 1 / 3d, 1e-6);
        checks.near("the smallest y", least(lamp, light -> light.position().y()), CENTER.y(), 1e-6);
        RenderedPicture picture = Twister.render(new SceneBuilder()
                .camera(Camera.of(new Vector3(0, 3, -7), 0, 20, 40))
                .lights(lamp)
                .sphere(Sphere.of(new Vector3(0, 1, 0), 1, new Rgb(0.9, 0.6, 0.2), 20))
                .rendering(Rendering.DEFAULT.withSize(320, 180).withShadowSamples(1)));
        picture.writePng(PICTURE);
        return checks.report(PICTURE + " has a ball, whose shadow is soft if the lamp is large");
    }

    private static double sum(List<Light> lights, ToDoubleFunction<Light> value) {
        return lights.stream().mapToDouble(value).sum();
    }

    private static double least(List<Light> lights, ToDoubleFunction<Light> value) {
        return lights.stream().mapToDouble(value).min().orElse(Double.NaN);
    }
}
