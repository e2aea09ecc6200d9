package dev.twister.render;

import dev.twister.image.ExrPicture;
import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.scene.Rgb;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The picture of an .exr file with light layers, with other strengths and colors of its lights. */
public final class RelitPicture {
    private static final Rgb UNCHANGED = new Rgb(1, 1, 1);

    private RelitPicture() {}

    /** Whether the file's colors are denoised, which those of the relit picture are not. */
    public static boolean wasDenoised(ExrPicture picture) {
        return picture.channels().stream().anyMatch(channel -> PictureLayers.NOISY.contains(channel.name()));
    }

    /**
     * The picture as the sum of its light layers, which are multiplied likewise. It is not denoised.
     *
     * @param factors of groups of lights
     * @throws IllegalArgumentException if a group has no layer; the message continues the file's name
     */
    public static ExrPicture of(ExrPicture picture, Map<String, Rgb> factors) {
        List<String> groups = PictureLayers.lightGroups(picture);
        if (groups.isEmpty()) {
            throw new IllegalArgumentException("has no light layers; render it with --light-layers");
        }
        factors.keySet().stream()
                .filter(name -> !groups.contains(name))
                .findFirst()
                .ifPresent(name -> {
                    throw new IllegalArgumentException(
                            "has no light layer '" + name + "'; it has: " + String.join(", ", groups));
                });
        float[] sum = new float[PictureLayers.COLORS.size() * picture.width() * picture.rows()];
        List<ExrChannel> channels = new ArrayList<>(picture.channels());
        for (String group : groups) {
            List<String> names = PictureLayers.light(group);
            float[] light = PictureLayers.of(picture, names)
                    .orElseThrow(() -> new IllegalArgumentException("has a damaged light layer '" + group + "'"));
            multiply(light, factors.getOrDefault(group, UNCHANGED));
            for (int i = 0; i < sum.length; i++) {
                sum[i] += light[i];
            }
            channels.removeIf(channel -> names.contains(channel.name()));
            channels.addAll(PictureLayers.channels(names, light, 0));
        }
        channels.removeIf(channel ->
                PictureLayers.COLORS.contains(channel.name()) || PictureLayers.NOISY.contains(channel.name()));
        channels.addAll(PictureLayers.channels(PictureLayers.COLORS, sum, 0));
        return new ExrPicture(
                picture.width(), picture.height(), picture.firstRow(), picture.rows(), channels, picture.provenance());
    }

    private static void multiply(float[] light, Rgb factor) {
        float[] factors = {(float) factor.red(), (float) factor.green(), (float) factor.blue()};
        for (int i = 0; i < light.length; i++) {
            light[i] *= factors[i % factors.length];
        }
    }
}
