package dev.twister.image;

/**
 * Times of rendering a frame, in nanoseconds.
 *
 * @param totalNanos from the call to the pixels in the caller's array
 * @param kernelNanos on the device, by the device's own clock; equal to the total on the JVM
 * @param copyInNanos host to device; 0 on the JVM
 * @param copyOutNanos device to host; 0 on the JVM
 */
public record FrameTimes(long totalNanos, long kernelNanos, long copyInNanos, long copyOutNanos) {
    public static final FrameTimes NONE = new FrameTimes(0, 0, 0, 0);

    /** Times of a frame rendered by the JVM. */
    public static FrameTimes onJvm(long totalNanos) {
        return new FrameTimes(totalNanos, totalNanos, 0, 0);
    }

    /** The sum of the times of two renders. */
    public FrameTimes plus(FrameTimes next) {
        return new FrameTimes(
                totalNanos + next.totalNanos,
                kernelNanos + next.kernelNanos,
                copyInNanos + next.copyInNanos,
                copyOutNanos + next.copyOutNanos);
    }
}
