package dev.twister.exr;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/** Which channels are the colors of a picture of any program. */
public final class ExrColors {
    private static final List<List<String>> COLORS = List.of(List.of("r", "g", "b"), List.of("red", "green", "blue"));

    /** Layers that are the picture itself, in programs that name it. */
    private static final List<String> PICTURES = List.of("combined", "beauty", "rgba", "rgb", "color");

    private ExrColors() {}

    /**
     * Red, green and blue: those without a layer, else those of the layer that is the picture or comes first; else one
     * gray channel three times.
     *
     * @param names of channels, such as {@code ViewLayer.Combined.R}
     * @return three names; none if there are no colors
     */
    public static List<String> of(List<String> names) {
        List<List<String>> layers = new ArrayList<>();
        for (String name : names) {
            String layer = layer(name);
            for (List<String> colors : COLORS) {
                List<String> found = colors.stream()
                        .flatMap(color -> names.stream()
                                .filter(other ->
                                        other.toLowerCase(Locale.ROOT).equals((layer + color).toLowerCase(Locale.ROOT))
                                                && layer(other).equals(layer))
                                .limit(1))
                        .toList();
                if (found.size() == colors.size() && !layers.contains(found)) {
                    layers.add(found);
                }
            }
        }
        if (!layers.isEmpty()) {
            return layers.stream()
                    .min(Comparator.comparingInt(found -> rank(layer(found.getFirst()))))
                    .orElseThrow();
        }
        return names.stream()
                .filter(name -> names.size() == 1 || name.equals("Y"))
                .findFirst()
                .map(gray -> List.of(gray, gray, gray))
                .orElse(List.of());
    }

    /** What precedes the channel's own name, with the dot. */
    private static String layer(String name) {
        return name.substring(0, name.lastIndexOf('.') + 1);
    }

    private static int rank(String layer) {
        if (layer.length() <= 1) {
            return 0;
        }
        String name = layer.substring(0, layer.length() - 1).toLowerCase(Locale.ROOT);
        int picture = PICTURES.indexOf(name.substring(name.lastIndexOf('.') + 1));
        return picture < 0 ? PICTURES.size() + 1 : picture + 1;
    }
}
