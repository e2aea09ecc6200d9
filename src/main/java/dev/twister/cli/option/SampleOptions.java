package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import dev.twister.render.Sampling;
import dev.twister.scene.Rendering;
import dev.twister.world.StageOrView;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Options for the number of samples per pixel. */
public final class SampleOptions {
    private static final double LEAST_NOISE = 1e-4;

    @Option(
            names = "--samples",
            paramLabel = "N",
            description = "View rays per pixel, 1 to " + Rendering.MAX_SAMPLES_PER_PIXEL
                    + "; with --noise, the limit (default: " + Sampling.USUAL_LIMIT + ").")
    private Optional<Integer> samples = Optional.empty();

    @Option(
            names = "--noise",
            paramLabel = "T",
            description = "Add samples until the estimated error of a pixel, as a share of white, is below T (such as"
                    + " 0.01) in every tile of 16 x 16 pixels.")
    private Optional<Double> noise = Optional.empty();

    boolean isGiven() {
        return samples.isPresent();
    }

    public boolean isNoiseGiven() {
        return noise.isPresent();
    }

    /**
     * Rejects a noise bound for pictures of numbers.
     *
     * @throws BadInputException if a picture has numbers, whose noise is not defined
     */
    public void check(List<StageOrView> pictures) {
        if (noise.isPresent() && !pictures.stream().allMatch(StageOrView::isColor)) {
            throw new BadInputException(
                    "--noise works for pictures of colors only; use --samples for views of numbers");
        }
    }

    /** The sampling, with the scene's number of samples as the default. */
    public Sampling over(int usual) {
        int least = noise.isPresent() ? Sampling.LEAST_CONVERGING : 1;
        return new Sampling(
                Ranges.check(
                        noise.isPresent() ? "--samples with --noise" : "--samples",
                        samples.orElse(noise.isPresent() ? Sampling.USUAL_LIMIT : usual),
                        least,
                        Rendering.MAX_SAMPLES_PER_PIXEL),
                noise.map(bound -> Ranges.check("--noise", bound, LEAST_NOISE, 1)));
    }
}
