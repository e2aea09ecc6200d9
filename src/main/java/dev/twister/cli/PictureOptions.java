package dev.twister.cli;

import dev.twister.world.StageOrView;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Options for what is rendered: the picture, a stage, or views. */
final class PictureOptions {
    @Option(
            names = "--stage",
            paramLabel = "NAME",
            converter = PictureConverter.OfStage.class,
            completionCandidates = Completions.OfStage.class,
            description = "Stop at a stage of the picture: ${COMPLETION-CANDIDATES} (the full picture).")
    private Optional<StageOrView> stage = Optional.empty();

    @Option(
            names = "--view",
            paramLabel = "NAME",
            split = ",",
            converter = PictureConverter.OfView.class,
            completionCandidates = Completions.OfView.class,
            description =
                    "Render values per pixel: ${COMPLETION-CANDIDATES}. Several names, separated by commas, become"
                            + " layers of an"
                            + " .exr file.")
    private List<StageOrView> views = List.of();

    /**
     * The pictures in the order of the options; at least one.
     *
     * @throws BadInputException if a view is named twice, or together with a stage
     */
    List<StageOrView> pictures() {
        if (stage.isPresent() && !views.isEmpty()) {
            throw new BadInputException("--stage and --view exclude each other; give one of them");
        }
        if (views.stream().distinct().count() < views.size()) {
            throw new BadInputException("--view has the same name twice; give each once");
        }
        return views.isEmpty() ? List.of(stage.orElse(StageOrView.BEAUTY)) : views;
    }
}
