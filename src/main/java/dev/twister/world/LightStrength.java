package dev.twister.world;

import dev.twister.kernel.SunEmitter;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.light.Lights;
import java.util.List;

/** How bright a light is in path tracing. */
public final class LightStrength {
    private LightStrength() {}

    /**
     * The radiance of each light's surface: {@code color * strength / radius^2}, or of a sun's disc, with the sine of
     * the angle that its radius fills instead of the radius.
     */
    public static List<Rgb> radiances(Lights lights, Ground ground) {
        return lights.list().stream().map(light -> radiance(light, ground)).toList();
    }

    private static Rgb radiance(Light light, Ground ground) {
        double radius = light.isSun() ? Math.max(light.shape().discSine(), SunEmitter.LEAST_SINE) : light.radius();
        double factor = light.strength().orElseGet(() -> usual(light, ground)) / (radius * radius);
        return new Rgb(
                light.color().red() * factor,
                light.color().green() * factor,
                light.color().blue() * factor);
    }

    /**
     * The strength of a light that states none: the squared distance of the nearest point of the ground, at least 1
     * m^2: a white surface there that faces the light is as bright as the light's color, as it is without path tracing.
     * A sun's is 1.
     */
    public static double usual(Light light, Ground ground) {
        if (light.isSun()) {
            return 1;
        }
        double half = ground.size() / 2;
        double x = light.position().x() - Math.clamp(light.position().x(), -half, half);
        double y = light.position().y() - ground.height();
        double z = light.position().z() - Math.clamp(light.position().z(), -half, half);
        return Math.max(1, x * x + y * y + z * z);
    }
}
