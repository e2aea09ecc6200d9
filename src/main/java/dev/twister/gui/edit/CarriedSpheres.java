package dev.twister.gui.edit;

import dev.twister.physics.SameSpheres;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;

/** Spheres between which an edit leads, when time has moved some since. */
final class CarriedSpheres {
    private CarriedSpheres() {}

    /**
     * Applies the edit that turned one list into another to the present list: spheres that the edit does not move stay
     * at their present places.
     *
     * @param present the spheres of {@code from}, in the same order, at their present places
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
