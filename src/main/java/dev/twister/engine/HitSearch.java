package dev.twister.engine;

import dev.twister.kernel.Hit;
import dev.twister.world.FrameInput;

/** By which of the kernel's searches the closest hits of a scene are found. */
public final class HitSearch {
    private HitSearch() {}

    /**
     * {@link Hit#ALL} or {@link Hit#WALK}. The loop over few spheres is small enough for the JVM's compiler to become
     * part of the kernel's code, the walk is not. A scene keeps its search while spheres are poured: TornadoVM would
     * compile the kernel again.
     */
    public static int of(FrameInput input) {
        return input.hasFewSpheres() ? Hit.ALL : Hit.WALK;
    }
}
