package dev.twister.denoise;

import java.util.Optional;

/** Offers a denoiser; found by {@link java.util.ServiceLoader} and listed by {@link Denoisers}. */
public interface DenoiserProvider {
    /** The denoiser on this machine, even if it cannot run here. Never throws; may take some 0.1 s. */
    Optional<DenoiserOffer> offer();
}
