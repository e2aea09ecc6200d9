package dev.twister.gui.edit;

import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SequencedMap;
import java.util.function.ToDoubleFunction;

/** Bodies that are dragged together, at their places when the drag started. */
public final class DraggedBodies {
    private final SequencedMap<Integer, Vector3> places = new LinkedHashMap<>();
    private final int active;
    private final Vector3 held;
    private final Vector3 least;
    private final Vector3 most;

    /**
     * Takes what is movable and not locked of a selection, by its active body.
     *
     * @param scene with the bodies at their displayed places
     */
    public DraggedBodies(Scene scene, SelectedBodies selected) {
        active = selected.active();
        held = BodyEdits.position(scene, active);
        for (int body : selected.bodies()) {
            if (BodyEdits.isFree(scene, body)) {
                places.put(body, BodyEdits.position(scene, body));
            }
        }
        // The group keeps its shape: it stops when the first body reaches the limit of the scene's coordinates.
        least = new Vector3(least(Vector3::x), least(Vector3::y), least(Vector3::z));
        most = new Vector3(most(Vector3::x), most(Vector3::y), most(Vector3::z));
    }

    /** Where the body by which they were taken was. */
    public Vector3 held() {
        return held;
    }

    /** The scene with that body there, and all others moved as far. */
    public Scene moved(Scene scene, Vector3 wanted) {
        Vector3 to = wanted.map(least, Math::max).map(most, Math::min);
        Map<Integer, Vector3> moved = new LinkedHashMap<>();
        places.forEach((body, place) -> moved.put(body, body == active ? to : movedAsFar(place, to)));
        return BodyEdits.moved(scene, moved);
    }

    private Vector3 movedAsFar(Vector3 place, Vector3 to) {
        return SceneLimits.POSITION.clamp(place.plus(to.minus(held)));
    }

    private double least(ToDoubleFunction<Vector3> axis) {
        double lowest = places.values().stream().mapToDouble(axis).min().orElseThrow();
        return SceneLimits.POSITION.min() + (axis.applyAsDouble(held) - lowest);
    }

    private double most(ToDoubleFunction<Vector3> axis) {
        double highest = places.values().stream().mapToDouble(axis).max().orElseThrow();
        // Rounding must not put it below the least.
        return Math.max(least(axis), SceneLimits.POSITION.max() - (highest - axis.applyAsDouble(held)));
    }
}
