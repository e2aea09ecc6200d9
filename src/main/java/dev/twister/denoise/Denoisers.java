package dev.twister.denoise;

import java.util.List;
import java.util.ServiceLoader;

/** Finds this machine's denoiser. */
public final class Denoisers {
    private Denoisers() {}

    /** The first denoiser that works, else one that does not, with the reason. Looking may take some 0.1 s. */
    public static DenoiserOffer offer() {
        List<DenoiserOffer> offers = ServiceLoader.load(DenoiserProvider.class).stream()
                .flatMap(provider -> provider.get().offer().stream())
                .toList();
        return offers.stream().filter(DenoiserOffer::works).findFirst().orElseGet(offers::getFirst);
    }

    /**
     * Opens this machine's denoiser.
     *
     * @throws DenoiseException if there is none, with what to do
     */
    public static Denoiser open() {
        return offer().opener().get();
    }
}
