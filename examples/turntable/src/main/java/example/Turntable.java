package example;

import dev.twister.RenderedPicture;
import dev.twister.SceneBuilder;
import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.scene.Camera;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.sky.DaylightSky;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.file.Path;

/** Renders a glass ball and a mirror from a camera that goes round them: one engine, one frame, one world. */
public final class Turntable {
    private static final int FRAMES = 4;
    private static final double DISTANCE = 8;

    private Turntable() {}

    /** Writes frame-0.png to frame-3.png into the folder that is named. */
    public static void main(String[] arguments) throws IOException {
        Path folder = Path.of(arguments[0]);
        World world = new SceneBuilder()
                .light(Light.of(new Vector3(-4, 9, -3), 1, new Rgb(1, 0.95, 0.9)))
                .sphere(Sphere.of(new Vector3(-1.3, 1, 0), 1, Material.DEFAULT.withTransmission(1)))
                .sphere(Sphere.of(new Vector3(1.3, 1, 0), 1, Material.DEFAULT.withReflectivity(110)))
                .sky(DaylightSky.panorama(512, 256, 35, 120, 3))
                .rendering(Rendering.DEFAULT.withSize(320, 180).withShadowSamples(32).withBounces(6))
                .world();
        Frame frame = Frame.ofPixels(320, 180);
        try (Engine engine = Engines.open("vector")) {
            for (int i = 0; i < FRAMES; i++) {
                world.setCamera(camera(360.0 * i / FRAMES));
                engine.render(world.snapshot(), frame);
                new RenderedPicture(frame, true).writePng(folder.resolve("frame-" + i + ".png"));
            }
        }
    }

    /** Looks at the y axis from an angle about it, in degrees. */
    private static Camera camera(double angle) {
        double radians = Math.toRadians(angle);
        Vector3 position = new Vector3(-DISTANCE * Math.sin(radians), 2.5, -DISTANCE * Math.cos(radians));
        return Camera.of(position, angle, 12, 40);
    }
}
