package dev.twister.scene.light;

import dev.twister.scene.Light;
import dev.twister.scene.property.SceneLimits;
import java.util.ArrayList;
import java.util.List;

/** The lights of a scene, at least one; the first is body 0. */
public record Lights(List<Light> list) {
    /** @throws IllegalArgumentException unless there are 1 to {@link SceneLimits#MAX_LIGHTS} */
    public Lights {
        list = List.copyOf(list);
        if (list.isEmpty() || list.size() > SceneLimits.MAX_LIGHTS) {
            throw new IllegalArgumentException(
                    list.size() + " lights; a scene has 1 to " + SceneLimits.MAX_LIGHTS + " of them");
        }
    }

    public static Lights of(Light light) {
        return new Lights(List.of(light));
    }

    public Light first() {
        return list.getFirst();
    }

    public Light get(int index) {
        return list.get(index);
    }

    /** The lights that have a place. */
    public List<Light> placed() {
        return list.stream().filter(light -> !light.isSun()).toList();
    }

    public int count() {
        return list.size();
    }

    /** With another light at an index. */
    public Lights with(int index, Light light) {
        List<Light> changed = new ArrayList<>(list);
        changed.set(index, light);
        return new Lights(changed);
    }

    /** With more lights after the last. */
    public Lights with(List<Light> more) {
        List<Light> all = new ArrayList<>(list);
        all.addAll(more);
        return new Lights(all);
    }
}
