package dev.twister.cli;

import dev.twister.world.StageOrView;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads the name of a stage or of a view, in small or capital letters. */
final class PictureConverter {
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
