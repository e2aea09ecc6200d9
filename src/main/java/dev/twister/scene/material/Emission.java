package dev.twister.scene.material;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.Rgb;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.property.Copied;

/**
 * Light that a body emits.
 *
 * @param color linear color, 0 or more; black for none
 * @param strength factor of the color, 0 or more
 * @param doubleSided whether triangles emit on both sides; otherwise on the outer one alone. Spheres emit outward.
 * @param group name of the layer that the light goes to, see {@link LightGroup}
 */
@Copied
public record Emission(Rgb color, double strength, boolean doubleSided, String group) implements EmissionCopy.With {
    public static final Emission NONE = new Emission(new Rgb(0, 0, 0), 1, true, LightGroup.NONE);

    public Emission {
        requireNonNull(color, "color");
        requireNonNull(group, "group");
    }

    /** The emitted radiance. */
    public Rgb radiance() {
        return new Rgb(color.red() * strength, color.green() * strength, color.blue() * strength);
    }

    public boolean isNone() {
        return strength * (color.red() + color.green() + color.blue()) == 0;
    }
}
