package dev.twister.gui.model;

import dev.twister.physics.SameSpheres;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;

/** Spheres between which an edit leads, when time has moved some since. */
final class CarriedSpheres {
    private CarriedSpheres() {}

    /**
     * What the edit from the one list to the other makes of the present one: a sphere that it does not put elsewhere
     * stays where it is at present.
     *
     * @param present those of {@code from}, one by one, where they are by now
     */
    static List<Sphere> of(List<Sphere> from, List<Sphere> to, List<Sphere> present) {
        if (present.equals(from)) {
            return to;
        }
        int[] same = SameSpheres.of(from, to);
        List<Sphere> carried = new ArrayList<>(to);
        for (int index = 0; index < same.length; index++) {
            int number = same[index];
            Sphere sphere = to.get(index);
            if (number != SameSpheres.NONE && from.get(number).position().equals(sphere.position())) {
                Vector3 now = present.get(number).position();
                carried.set(index, sphere.withPosition(now));
            }
        }
        return carried;
    }
}
