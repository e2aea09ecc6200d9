import dev.twister.SceneBuilder;
import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.image.PngWriter;
import dev.twister.scene.Camera;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.DoubleUnaryOperator;

/** Checks a tone map, and shows it: {@code java -cp CLASSPATH CheckToneMap.java [solution]}. */
final class CheckToneMap {
    private static final Path PICTURE = Path.of("tone-map.png");
    private static final double STEP = 0.25;
    private static final double SRGB = 1 / 2.2;

    private CheckToneMap() {}

    public static void main(String[] arguments) throws IOException {
        System.exit(run(arguments));
    }

    static int run(String... arguments) throws IOException {
        DoubleUnaryOperator map = Checks.isSolution(arguments) ? ToneMapSolution::shown : ToneMapAttempt::shown;
        Checks checks = new Checks();
        checks.near("shown(0)", map.applyAsDouble(0), 0, 1e-9);
        checks.near("shown(0.01)", map.applyAsDouble(0.01), 0.01, 2e-4);
        checks.near("shown(1)", map.applyAsDouble(1), 17 / 32d, 1e-6);
        checks.near("shown(2)", map.applyAsDouble(2), 0.75, 1e-6);
        checks.near("shown(4), the white point,", map.applyAsDouble(4), 1, 1e-6);
        checks.near("shown(100)", map.applyAsDouble(100), 1, 1e-6);
        checkRise(map, checks);
        write(map);
        return checks.report(PICTURE + " has a ball under a light that is three times as bright as white");
    }

    /** One line for each range in which shapes are lost. */
    private static void checkRise(DoubleUnaryOperator map, Checks checks) {
        double start = 0;
        for (double color = 0; color <= 4; color += STEP) {
            boolean rises = color == 4 || map.applyAsDouble(color + STEP) > map.applyAsDouble(color);
            if (rises) {
                checks.that(
                        start == color,
                        String.format(
                                Locale.ROOT,
                                "between %.2f and %.2f it does not rise: shapes are lost there",
                                start,
                                color));
                start = color + STEP;
            }
        }
    }

    private static void write(DoubleUnaryOperator map) throws IOException {
        FrameInput input = new SceneBuilder()
                .camera(Camera.of(new Vector3(0, 1.5, -6), 0, 5, 40))
                .light(Light.of(new Vector3(-4, 6, -5), 0.5, new Rgb(3, 3, 3)))
                .sphere(Sphere.of(new Vector3(0, 1, 0), 1, new Rgb(0.9, 0.3, 0.2), 60))
                .rendering(Rendering.DEFAULT.withSize(320, 180).withShadowSamples(16))
                .world()
                .snapshot();
        Frame linear = Frame.ofRadiance(input.width(), input.height());
        try (Engine engine = Engines.open("parallel")) {
            engine.render(input, linear);
        }
        int[] argb = new int[input.width() * input.height()];
        for (int i = 0; i < argb.length; i++) {
            argb[i] = 0xFF000000
                    | channel(map, linear.radiance()[3 * i]) << 16
                    | channel(map, linear.radiance()[3 * i + 1]) << 8
                    | channel(map, linear.radiance()[3 * i + 2]);
        }
        PngWriter.write(PICTURE, input.width(), input.height(), argb, true);
    }

    private static int channel(DoubleUnaryOperator map, float color) {
        return (int) Math.round(255 * Math.pow(Math.clamp(map.applyAsDouble(color), 0, 1), SRGB));
    }
}
