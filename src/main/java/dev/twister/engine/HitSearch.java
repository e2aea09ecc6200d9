package dev.twister.engine;

import dev.twister.kernel.Hit;
import dev.twister.world.FrameInput;

/** Chooses the kernel's algorithm for closest hits. */
public final class HitSearch {
    private HitSearch() {}

    /**
     * {@link Hit#ALL} or {@link Hit#WALK}. With few spheres the brute-force loop is inlined into the kernel, which the
     * traversal is too large for. The choice does not change while spheres are poured, because TornadoVM would
     * recompile the kernel.
     */
    public static int of(FrameInput input) {
        return input.hasFewSpheres() ? Hit.ALL : Hit.WALK;
    }
}
