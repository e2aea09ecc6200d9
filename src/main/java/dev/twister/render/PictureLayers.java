package dev.twister.render;

import dev.twister.image.ExrPicture;
import dev.twister.image.ExrPicture.ExrChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Layers of three channels in .exr files, as three floats per pixel. */
public final class PictureLayers {
    /** The picture itself. */
    public static final List<String> COLORS = List.of("R", "G", "B");

    /** The picture before its noise was removed. */
    public static final List<String> NOISY = layer("noisy", "RGB");

    /** Guides of denoising: colors and normals behind mirrors and clear glass. */
    static final List<String> GUIDE_ALBEDO = layer("guide-albedo", "RGB");

    static final List<String> GUIDE_NORMAL = layer("guide-normal", "XYZ");

    private static final String LIGHT = "light-";
    private static final String RED = ".R";

    private PictureLayers() {}

    /** The light of a group of lights. */
    public static List<String> light(String group) {
        return layer(LIGHT + group, "RGB");
    }

    /** The groups of lights whose light is in layers. */
    public static List<String> lightGroups(ExrPicture picture) {
        return picture.channels().stream()
                .map(ExrChannel::name)
                .filter(name -> name.startsWith(LIGHT) && name.endsWith(RED))
                .map(name -> name.substring(LIGHT.length(), name.length() - RED.length()))
                .sorted()
                .toList();
    }

    /** Names of three channels, such as {@code normal.R}. */
    static List<String> layer(String name, String channels) {
        return channels.chars().mapToObj(channel -> name + "." + (char) channel).toList();
    }

    /** The values of three channels, row by row from the top; empty if a channel is missing. */
    public static Optional<float[]> of(ExrPicture picture, List<String> names) {
        List<ExrChannel> found = names.stream()
                .flatMap(name -> picture.channels().stream()
                        .filter(channel -> channel.name().equals(name)))
                .toList();
        if (found.size() < names.size()) {
            return Optional.empty();
        }
        float[] values = new float[Math.multiplyExact(names.size(), picture.width() * picture.rows())];
        for (int channel = 0; channel < names.size(); channel++) {
            ExrChannel from = found.get(channel);
            for (int i = channel; i < values.length; i += names.size()) {
                values[i] = from.values()[from.first() + from.stride() * (i / names.size())];
            }
        }
        return Optional.of(values);
    }

    /**
     * Channels of a layer.
     *
     * @param values with as many floats per pixel as there are names
     * @param first index of the first pixel's first value
     */
    static List<ExrChannel> channels(List<String> names, float[] values, int first) {
        List<ExrChannel> channels = new ArrayList<>();
        for (int channel = 0; channel < names.size(); channel++) {
            channels.add(new ExrChannel(names.get(channel), values, first + channel, names.size()));
        }
        return channels;
    }
}
