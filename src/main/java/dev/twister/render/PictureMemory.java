package dev.twister.render;

import dev.twister.image.PictureSize;
import java.util.Optional;

/** Whether a picture fits in what the JVM may still use. */
public final class PictureMemory {
    private static final long MEGABYTE = 1 << 20;
    private static final int SPARE_MEGABYTES = 1024;

    private PictureMemory() {}

    /**
     * What a picture lacks.
     *
     * @param needed megabytes that it takes
     * @param available megabytes that the JVM may still use
     * @param limit megabytes that the JVM may use in all
     */
    public record Shortage(PictureSize size, long needed, long available, long limit) {
        /** The limit in megabytes that would be enough, with some spare. */
        public long sufficientLimit() {
            return limit + needed - available + SPARE_MEGABYTES;
        }

        /** What is needed and what there is, as the rest of a sentence that begins with the size's name. */
        public String text() {
            return "is " + size + ", which needs " + needed + " MB of memory, but the JVM may use only " + available
                    + " MB more";
        }
    }

    /** Looks before anything is allocated; empty where the picture fits. */
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
