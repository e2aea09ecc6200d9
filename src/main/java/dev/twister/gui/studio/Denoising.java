package dev.twister.gui.studio;

import dev.twister.denoise.DenoiserOffer;
import dev.twister.denoise.Denoisers;
import dev.twister.denoise.GuidedFilter;
import java.util.Optional;
import java.util.function.Consumer;

/** Turns the denoising of the window's picture on and off. */
public final class Denoising {
    private Denoising() {}

    /**
     * Denoises from now on: by Twister's own filter until a better denoiser is found.
     *
     * @param complain takes why there is none
     */
    public static void start(Studio studio, BackgroundTasks tasks, Consumer<String> complain) {
        studio.denoiserProperty().set(Optional.of(GuidedFilter.OFFER));
        tasks.run(
                Denoisers::offer,
                offer -> use(studio, offer, complain),
                problem -> complain.accept(problem.toString()));
    }

    private static void use(Studio studio, DenoiserOffer offer, Consumer<String> complain) {
        if (studio.denoiserProperty().get().isPresent()) {
            offer.obstacle()
                    .ifPresentOrElse(
                            reason -> complain.accept("Denoising with Twister's own filter: " + reason),
                            () -> studio.denoiserProperty().set(Optional.of(offer)));
        }
    }

    public static void stop(Studio studio) {
        studio.denoiserProperty().set(Optional.empty());
    }
}
