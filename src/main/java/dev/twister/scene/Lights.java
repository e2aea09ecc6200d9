package dev.twister.scene;

import java.util.List;

/** The lights of a scene. */
public record Lights(List<Light> list) {
    /** @throws IllegalArgumentException unless there is exactly one: nothing draws more of them yet */
    public Lights {
        list = List.copyOf(list);
        if (list.size() != 1) {
            throw new IllegalArgumentException(list.size() + " lights; a scene has 1");
        }
    }

    public static Lights of(Light light) {
        return new Lights(List.of(light));
    }

    public Light first() {
        return list.getFirst();
    }
}
