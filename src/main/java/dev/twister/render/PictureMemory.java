package dev.twister.render;

import dev.twister.image.PictureSize;
import java.util.Optional;

/** Checks whether a picture fits into the free memory of the JVM. */
public final class PictureMemory {
    private static final long MEGABYTE = 1 << 20;
    private static final int SPARE_MEGABYTES = 1024;

    private PictureMemory() {}

    /**
     * A picture that does not fit.
     *
     * @param needed required megabytes
     * @param available free megabytes
     * @param limit maximum heap in megabytes
     */
    public record Shortage(PictureSize size, long needed, long available, long limit) {
        /** A sufficient heap limit in megabytes. */
        public long sufficientLimit() {
            return limit + needed - available + SPARE_MEGABYTES;
        }

        /** Required and free memory, as the rest of a sentence that begins with the option's name. */
        public String text() {
            return "is " + size + ", which needs " + needed + " MB of memory, but the JVM may use only " + available
                    + " MB more";
        }
    }

    /** Empty if the picture fits. Allocates nothing. */
    public static Optional<Shortage> of(PictureSize size, long bytesPerPixel) {
        Runtime runtime = Runtime.getRuntime();
        long available = runtime.maxMemory() - (runtime.totalMemory() - runtime.freeMemory());
        long needed = size.pixels() * bytesPerPixel;
        return needed > available
                ? Optional.of(
                        new Shortage(size, needed / MEGABYTE, available / MEGABYTE, runtime.maxMemory() / MEGABYTE))
                : Optional.empty();
    }
}
