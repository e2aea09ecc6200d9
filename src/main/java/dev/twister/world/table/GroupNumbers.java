package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.world.LightGroups;
import java.util.ArrayList;
import java.util.List;

/** Numbers groups of lights in the order in which they are first named. */
public final class GroupNumbers {
    private final List<String> names = new ArrayList<>();
    private final float[] layers;

    /** @param length number of bodies, and one for the sky */
    public GroupNumbers(int length) {
        layers = new float[length];
    }

    /** Puts a body, or the sky as {@link Layout#NOTHING}, in a group. */
    public void put(int body, String name) {
        if (!names.contains(name)) {
            names.add(name);
        }
        layers[1 + body] = names.indexOf(name);
    }

    public LightGroups groups() {
        if (names.size() > Layout.MOST_LIGHT_LAYERS) {
            throw new IllegalArgumentException(
                    names.size() + " groups of lights; there are at most " + Layout.MOST_LIGHT_LAYERS);
        }
        return new LightGroups(List.copyOf(names), layers);
    }
}
