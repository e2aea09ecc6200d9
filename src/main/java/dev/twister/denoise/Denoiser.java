package dev.twister.denoise;

/** Removes noise. Only one thread at a time may use a denoiser. */
public interface Denoiser extends AutoCloseable {
    /**
     * The picture without its noise: linear red, green and blue of each pixel, row by row from the top. Values of the
     * radiance or of a guide that are not finite count as 0.
     *
     * @throws DenoiseException if the library or its device fails
     */
    float[] denoise(NoisyPicture picture);

    /** Releases all resources; never throws. */
    @Override
    void close();
}
