package dev.twister.render;

import dev.twister.engine.ConvergingPicture;
import dev.twister.engine.ConvergingPicture.Converged;
import dev.twister.engine.ConvergingPicture.Convergence;
import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * How many samples each pixel gets.
 *
 * @param samples number per pixel; with a noise bound, the limit
 * @param noise bound of the estimated error of a pixel, as a share of white
 */
public record Sampling(int samples, Optional<Double> noise) {
    /** Smallest limit with a noise bound; fewer samples give no estimate of the noise. */
    public static final int LEAST_CONVERGING = 8;

    /** Limit with a noise bound if no other is given. */
    public static final int USUAL_LIMIT = 4096;

    /** In one call of an engine. */
    private static final int MOST_AT_ONCE = 1024;

    /**
     * Renders a band.
     *
     * @param input with as many samples per pixel, unless {@link #isGradual}
     * @param watcher called after each pass of samples
     * @return the number of samples of each tile and the noise, which is 0 if it was not estimated
     */
    public Converged draw(Engine engine, FrameInput input, Frame frame, Consumer<Convergence> watcher) {
        if (isGradual()) {
            return ConvergingPicture.draw(engine, input, frame, noise.orElse(0.0), samples, watcher);
        }
        engine.render(input, frame);
        return new Converged(new Convergence(samples, 0, 1), new int[] {samples});
    }

    /** Whether samples are rendered in passes. */
    boolean isGradual() {
        return noise.isPresent() || samples > MOST_AT_ONCE;
    }

    /** Text for metadata of files. */
    String text() {
        return noise.map(bound -> "noise " + bound + " at most " + samples).orElse(Integer.toString(samples));
    }
}
