package dev.twister.image;

/**
 * Times of rendering a frame, in nanoseconds.
 *
 * @param totalNanos from the call to the pixels in the caller's array
 * @param kernelNanos on the device, by the device's own clock; equal to the total on the JVM
 * @param copyInNanos host to device; 0 on the JVM
 * @param copyOutNanos device to host; 0 on the JVM
 * @param processorNanos of all threads together; 0 if unknown, as on devices
 */
public record FrameTimes(long totalNanos, long kernelNanos, long copyInNanos, long copyOutNanos, long processorNanos) {
    public static final FrameTimes NONE = new FrameTimes(0, 0, 0, 0, 0);

    private static final int CORES = Runtime.getRuntime().availableProcessors();

    /** Times of a frame rendered by a device. */
    public FrameTimes(long totalNanos, long kernelNanos, long copyInNanos, long copyOutNanos) {
        this(totalNanos, kernelNanos, copyInNanos, copyOutNanos, 0);
    }

    /** Times of a frame rendered by the JVM. */
    public static FrameTimes onJvm(long totalNanos) {
        return onJvm(totalNanos, 0);
    }

    /** Times of a frame rendered by the JVM, with the processor time of all threads. */
    public static FrameTimes onJvm(long totalNanos, long processorNanos) {
        return new FrameTimes(totalNanos, totalNanos, 0, 0, processorNanos);
    }

    /**
     * The time for comparing engines, in nanoseconds: that of the processor for each of its cores, which does not
     * depend on other work on the machine; if it is unknown, the total.
     */
    public long effortNanos() {
        return processorNanos > 0 ? Math.max(1, processorNanos / CORES) : totalNanos;
    }

    /** The sum of the times of two renders. */
    public FrameTimes plus(FrameTimes next) {
        return new FrameTimes(
                totalNanos + next.totalNanos,
                kernelNanos + next.kernelNanos,
                copyInNanos + next.copyInNanos,
                copyOutNanos + next.copyOutNanos,
                processorNanos + next.processorNanos);
    }
}
