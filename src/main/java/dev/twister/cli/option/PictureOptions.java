package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import dev.twister.world.StageOrView;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** Options for what is rendered: the picture, a stage, or views. */
public final class PictureOptions {
    @Option(
            names = "--stage",
            paramLabel = "STAGE",
            converter = PictureConverter.OfStage.class,
            completionCandidates = Completions.OfStage.class,
            description = "Stop at a stage of the picture: ${COMPLETION-CANDIDATES} (the full picture).")
    private Optional<StageOrView> stage = Optional.empty();

    @Option(
            names = "--view",
            paramLabel = "VIEW",
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
    public List<StageOrView> pictures() {
        if (stage.isPresent() && !views.isEmpty()) {
            throw new BadInputException("--stage and --view exclude each other; give one of them");
        }
        if (views.stream().distinct().count() < views.size()) {
            throw new BadInputException("--view has the same name twice; give each once");
        }
        return views.isEmpty() ? List.of(stage.orElse(StageOrView.BEAUTY)) : views;
    }

    /** Reads the name of a stage or of a view, in small or capital letters. */
    private static final class PictureConverter {
        private PictureConverter() {}

        static final class OfStage implements ITypeConverter<StageOrView> {
            @Override
            public StageOrView convert(String text) {
                return find(text, StageOrView.stages(), StageOrView::stageId);
            }
        }

        static final class OfView implements ITypeConverter<StageOrView> {
            @Override
            public StageOrView convert(String text) {
                return find(text, StageOrView.views(), StageOrView::id);
            }
        }

        private static StageOrView find(String text, List<StageOrView> choices, Function<StageOrView, String> name) {
            return choices.stream()
                    .filter(choice -> name.apply(choice).equalsIgnoreCase(text))
                    .findFirst()
                    .orElseThrow(() -> new TypeConversionException("unknown value '" + text + "'; expected one of: "
                            + choices.stream().map(name).collect(Collectors.joining(", "))));
        }
    }
}
