package dev.twister.engine;

import dev.twister.kernel.PixelKernel;
import dev.twister.world.FrameInput;

/** Which of the kernel's shortcuts the engines draw a scene with. */
public final class Shortcuts {
    private Shortcuts() {}

    /**
     * {@link PixelKernel#FEW_SPHERES} or {@link PixelKernel#SHORTCUTS}. The loop over few spheres is small enough for the
     * JVM's compiler to become part of the kernel's code, the walk is not. A scene keeps its
     * shortcuts while spheres are poured: TornadoVM would compile the kernel again.
     */
    public static int of(FrameInput input) {
        return input.hasFewSpheres() ? PixelKernel.FEW_SPHERES : PixelKernel.SHORTCUTS;
    }
}
