package dev.twister.image;

/**
 * Where a frame's time went, in nanoseconds.
 *
 * @param totalNanos from the call to the pixels in the caller's array
 * @param kernelNanos on the device, by the device's own clock; equal to the total on the JVM
 * @param copyInNanos host to device; 0 on the JVM
 * @param copyOutNanos device to host; 0 on the JVM
 */
public record FrameTimes(long totalNanos, long kernelNanos, long copyInNanos, long copyOutNanos) {
    public static final FrameTimes NONE = new FrameTimes(0, 0, 0, 0);

    /** A frame drawn by the JVM itself. */
    public static FrameTimes onJvm(long totalNanos) {
        return new FrameTimes(totalNanos, totalNanos, 0, 0);
    }

    /** Of what was drawn one after the other. */
    public FrameTimes plus(FrameTimes next) {
        return new FrameTimes(
                totalNanos + next.totalNanos,
                kernelNanos + next.kernelNanos,
                copyInNanos + next.copyInNanos,
                copyOutNanos + next.copyOutNanos);
    }
}
