package dev.twister.gui.drawing;

import dev.twister.denoise.DenoiserOffer;
import java.util.Optional;

/**
 * How a picture at rest gets better.
 *
 * @param samples per pixel to gather before the picture rests; 0 to draw it again and again
 * @param noise at which a path-traced picture rests earlier, relative to white; 0 for none
 * @param denoiser removes the noise of a path-traced picture; empty to leave it
 */
public record Refinement(int samples, double noise, Optional<DenoiserOffer> denoiser) {
    /** To a number of samples alone. */
    public static Refinement to(int samples) {
        return new Refinement(samples, 0, Optional.empty());
    }
}
