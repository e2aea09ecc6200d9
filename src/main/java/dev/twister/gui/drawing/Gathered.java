package dev.twister.gui.drawing;

import java.util.OptionalDouble;

/**
 * What a picture was made of.
 *
 * @param samples per pixel, including those of earlier pictures that it refines
 * @param noise estimated standard error of the samples, relative to white; empty if it is unknown
 * @param denoised whether the noise was removed
 * @param isDone whether no more samples are gathered for it
 */
public record Gathered(int samples, OptionalDouble noise, boolean denoised, boolean isDone) {
    /** Samples of a picture that is not refined. */
    public static Gathered of(int samples) {
        return new Gathered(samples, OptionalDouble.empty(), false, false);
    }
}
