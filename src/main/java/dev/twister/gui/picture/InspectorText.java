package dev.twister.gui.picture;

import dev.twister.gui.edit.BodyNumber;
import dev.twister.scene.Rgb;
import dev.twister.world.StageOrView;
import java.util.Locale;

/** What the inspector says of a pixel. */
final class InspectorText {
    private InspectorText() {}

    /** @param body the body of the pixel, as the scene numbers it */
    static String of(PixelReading pixel, int body, StageOrView shown) {
        return String.format(
                Locale.ROOT,
                "x %d   y %d   RGB %d %d %d   #%06X%n%s%n%s   %d %s",
                pixel.x(),
                pixel.y(),
                pixel.argb() >> 16 & 255,
                pixel.argb() >> 8 & 255,
                pixel.argb() & 255,
                pixel.argb() & 0xFFFFFF,
                value(pixel.radiance(), shown),
                body == BodyNumber.NONE
                        ? "sky"
                        : String.format(Locale.ROOT, "%s, %.3f m away", bodyName(body), pixel.distance()),
                pixel.samples(),
                pixel.samples() == 1 ? "sample" : "samples");
    }

    /** A body as the scene numbers it. */
    static String bodyName(int body) {
        if (BodyNumber.mesh(body) < 0 && BodyNumber.light(body) > 0) {
            return "light " + (BodyNumber.light(body) + 1);
        }
        return switch (body) {
            case BodyNumber.NONE -> "sky";
            case BodyNumber.LIGHT -> "light";
            case BodyNumber.PLANE -> "plane";
            default ->
                BodyNumber.mesh(body) >= 0
                        ? "mesh " + (BodyNumber.mesh(body) + 1)
                        : "sphere " + (BodyNumber.sphere(body) + 1);
        };
    }

    private static String value(Rgb value, StageOrView shown) {
        String name = shown.isColor() ? "radiance" : shown.id();
        return shown.isNumber()
                ? String.format(Locale.ROOT, "%s %.5g", name, value.red())
                : String.format(Locale.ROOT, "%s %.5f %.5f %.5f", name, value.red(), value.green(), value.blue());
    }
}
