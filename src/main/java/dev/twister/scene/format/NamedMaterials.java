package dev.twister.scene.format;

import dev.twister.scene.Material;
import dev.twister.scene.format.json.Excerpt;
import dev.twister.scene.format.json.JsonText;
import dev.twister.scene.format.json.LocatedValue;
import dev.twister.scene.format.json.NearestName;
import java.util.HashMap;
import java.util.Map;
import java.util.SequencedMap;

/** The name of one of the scene's materials, which stands for that material. */
record NamedMaterials(SequencedMap<String, Material> byName, Map<Material, String> names)
        implements ValueType<Material> {
    private static final int MOST_SHOWN = 12;

    static NamedMaterials of(SequencedMap<String, Material> byName) {
        Map<Material, String> names = new HashMap<>();
        byName.forEach((name, material) -> names.putIfAbsent(material, name));
        return new NamedMaterials(byName, names);
    }

    /** Whether one of the scene's materials is that one. */
    boolean have(Material material) {
        return !names.isEmpty() && names.containsKey(material);
    }

    @Override
    public Material read(Place place) {
        if (!(place.value() instanceof LocatedValue.TextValue found)) {
            throw place.refused("the name of one of the scene's materials");
        }
        if (byName.containsKey(found.text())) {
            return byName.get(found.text());
        }
        throw place.refused("the name of one of the scene's materials" + hint(found.text()));
    }

    @Override
    public String write(Material value) {
        return JsonText.string(names.get(value));
    }

    private String hint(String unknown) {
        if (byName.isEmpty()) {
            return ", and there are none: $.materials is missing or empty";
        }
        String guess = NearestName.of(unknown, byName.keySet())
                .map(nearest -> " (did you mean " + Excerpt.quoted(nearest) + "?)")
                .orElse("");
        return guess + ": "
                + String.join(
                        ", ",
                        byName.keySet().stream()
                                .limit(MOST_SHOWN)
                                .map(Excerpt::quoted)
                                .toList())
                + (byName.size() > MOST_SHOWN ? ", ..." : "");
    }
}
