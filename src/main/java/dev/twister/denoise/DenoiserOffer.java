package dev.twister.denoise;

import java.util.Optional;
import java.util.function.Supplier;

/**
 * A denoiser of this machine, before it is opened.
 *
 * @param name with its version where that is known, for display
 * @param obstacle why it cannot run here and what to do; empty if it can run
 * @param opener opens the denoiser; throws {@link DenoiseException} if that fails or if there is an obstacle
 */
public record DenoiserOffer(String name, Optional<String> obstacle, Supplier<Denoiser> opener) {
    /** A denoiser that runs here. */
    public static DenoiserOffer working(String name, Supplier<Denoiser> opener) {
        return new DenoiserOffer(name, Optional.empty(), opener);
    }

    /** A denoiser that cannot run here, with the reason. */
    public static DenoiserOffer impossible(String name, String obstacle) {
        return new DenoiserOffer(name, Optional.of(obstacle), () -> {
            throw new DenoiseException(obstacle);
        });
    }

    /**
     * Checks that the denoiser can run, without opening it.
     *
     * @throws DenoiseException if there is an obstacle
     */
    public void check() {
        obstacle.ifPresent(reason -> {
            throw new DenoiseException(reason);
        });
    }

    public boolean works() {
        return obstacle.isEmpty();
    }
}
