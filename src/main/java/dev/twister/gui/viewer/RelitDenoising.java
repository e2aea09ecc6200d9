package dev.twister.gui.viewer;

import dev.twister.denoise.Denoiser;
import dev.twister.denoise.DenoiserOffer;
import dev.twister.denoise.Denoisers;
import dev.twister.denoise.NoisyPicture;
import dev.twister.scene.Rgb;
import java.util.List;
import java.util.Optional;

/** Removes the noise of a file's picture with other strengths and colors of its lights. Keeps the newest result. */
public final class RelitDenoising {
    private final ViewedPicture picture;
    private Optional<DenoiserOffer> offer = Optional.empty();
    private volatile Optional<Clean> newest = Optional.empty();

    @SuppressWarnings("ArrayRecordComponent") // never compared
    private record Clean(List<Rgb> factors, float[] radiance) {}

    public RelitDenoising(ViewedPicture picture) {
        this.picture = picture;
    }

    /** The radiance without noise, if it is known for these factors of the lights. */
    public Optional<float[]> known(List<Rgb> factors) {
        return picture.clean(factors)
                .or(() ->
                        newest.filter(clean -> clean.factors().equals(factors)).map(Clean::radiance));
    }

    /** Whether {@link #clean} has something to do. */
    public boolean isDue(List<Rgb> factors) {
        return picture.guides().isPresent() && known(factors).isEmpty();
    }

    /**
     * Removes the noise; may take seconds. Used by one thread at a time.
     *
     * @throws dev.twister.denoise.DenoiseException if there is no denoiser, or it fails
     */
    public float[] clean(List<Rgb> factors) {
        DenoiserOffer found = offer.orElseGet(Denoisers::offer);
        offer = Optional.of(found);
        NoisyPicture noisy = picture.noisy(factors);
        try (Denoiser denoiser = found.opener().get()) {
            float[] radiance = denoiser.denoise(noisy);
            newest = Optional.of(new Clean(factors, radiance));
            return radiance;
        }
    }
}
