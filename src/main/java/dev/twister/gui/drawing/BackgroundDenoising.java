package dev.twister.gui.drawing;

import dev.twister.denoise.Denoiser;
import dev.twister.denoise.DenoiserOffer;
import dev.twister.denoise.NoisyPicture;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Removes the noise of a picture at rest on a thread of its own, while it gathers more samples: whenever it has twice
 * as many as before, and when it is done. Used by the drawing thread.
 */
final class BackgroundDenoising implements AutoCloseable {
    private final Runnable whenReady;
    private final ExecutorService thread = Executors.newSingleThreadExecutor(
            Thread.ofPlatform().daemon().name("denoising").factory());

    /** Used by the thread alone. */
    private Optional<Denoiser> denoiser = Optional.empty();

    private Optional<Work> work = Optional.empty();
    private Optional<Clean> clean = Optional.empty();
    private Optional<String> failure = Optional.empty();
    private boolean outdated;

    private record Work(int samples, int guidedSamples, CompletableFuture<float[]> result) {}

    /**
     * A picture without its noise.
     *
     * @param radiance as {@link dev.twister.image.Frame#radiance}
     * @param samples of the noisy one
     * @param guidedSamples of them with guides
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    record Clean(float[] radiance, int samples, int guidedSamples) {}

    /** @param whenReady called on another thread when {@link #advance} has something to return */
    BackgroundDenoising(Runnable whenReady) {
        this.whenReady = whenReady;
    }

    /** Another picture is gathered from now on. */
    void reset() {
        clean = Optional.empty();
        failure = Optional.empty();
        outdated = work.isPresent();
    }

    /** Tries again what has failed. */
    void retry() {
        failure = Optional.empty();
    }

    /** Whether nothing is left to be done for a picture that is done. */
    boolean isDone(RefinedPicture picture) {
        return failure.isPresent()
                || clean.filter(newest -> newest.samples() == picture.samples()).isPresent();
    }

    /** The newest picture without its noise. */
    Optional<Clean> newest() {
        return clean;
    }

    /** Why there is none. */
    Optional<String> failure() {
        return failure;
    }

    /**
     * Takes what is finished, and begins with what has been gathered since.
     *
     * @param done whether the picture gathers no more samples
     * @return whether there is a new {@link #newest}, or a {@link #failure}
     */
    boolean advance(RefinedPicture picture, boolean done, DenoiserOffer offer) {
        boolean fresh = take();
        boolean due = (done && !isDone(picture))
                || picture.guidedSamples()
                        >= 2 * clean.map(Clean::guidedSamples).orElse(0)
                || picture.samples() >= 2 * clean.map(Clean::samples).orElse(0);
        if (work.isEmpty() && failure.isEmpty() && picture.guidedSamples() > 0 && due) {
            NoisyPicture noisy = picture.noisy();
            CompletableFuture<float[]> result =
                    CompletableFuture.supplyAsync(() -> opened(offer).denoise(noisy), thread);
            work = Optional.of(new Work(picture.samples(), picture.guidedSamples(), result));
            CompletableFuture<Void> _ = result.handle((_, _) -> null).thenRun(whenReady);
        }
        return fresh;
    }

    private boolean take() {
        Optional<Work> finished = work.filter(begun -> begun.result().isDone());
        if (finished.isEmpty()) {
            return false;
        }
        boolean wanted = !outdated;
        work = Optional.empty();
        outdated = false;
        try {
            Work begun = finished.get();
            float[] radiance = begun.result().join();
            clean = wanted ? Optional.of(new Clean(radiance, begun.samples(), begun.guidedSamples())) : clean;
        } catch (CompletionException problem) {
            failure = Optional.of("not denoised: " + problem.getCause().getMessage());
        }
        return wanted;
    }

    private Denoiser opened(DenoiserOffer offer) {
        if (denoiser.isEmpty()) {
            denoiser = Optional.of(offer.opener().get());
        }
        return denoiser.get();
    }

    @Override
    public void close() {
        thread.execute(() -> denoiser.ifPresent(Denoiser::close));
        thread.shutdown();
    }
}
