package dev.twister;

/** Follows the rendering of a picture, and may cancel it. */
@FunctionalInterface
public interface RenderListener {
    /**
     * A part of the picture is done. Called on the rendering thread; what it throws ends the rendering.
     *
     * @param part of the work that is done, in (0, 1]
     * @param samples per pixel so far
     * @param noise estimated standard error of the noisiest part of the picture, as a share of white; 0 where it is not
     *     estimated, as for fewer than 8 samples per pixel or an odd number of them
     */
    void progress(double part, int samples, double noise);

    /** Whether to stop. Asked often and by several threads; once true, it must stay true. */
    default boolean isCanceled() {
        return false;
    }
}
