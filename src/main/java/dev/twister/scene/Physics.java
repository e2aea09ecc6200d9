package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;

/**
 * How bodies move. Spheres have one density, so their mass is as their volume.
 *
 * @param gravity acceleration in m/s^2
 * @param elasticity coefficient of restitution in [0, 1]: the share of the approach speed with which two bodies part
 * @param friction Coulomb's coefficient, 0 or more; spheres do not spin, so that it stands for rolling resistance too
 * @param damping share of the speed that is lost in a second, as a rate c in 1/s: v' = -c v
 * @param walls whether four walls without an upper end stand on the plane's border
 * @param solidLight whether lights are bodies that can be hit, at rest for ever; otherwise spheres pass through them
 */
@Copied
public record Physics(
        Vector3 gravity, double elasticity, double friction, double damping, boolean walls, boolean solidLight)
        implements PhysicsCopy.With {
    /** What a scene file that is silent gets. */
    public static final Physics DEFAULT = new Physics(new Vector3(0, -9.81, 0), 0.5, 0.3, 0, true, false);

    public Physics {
        requireNonNull(gravity, "gravity");
    }
}
