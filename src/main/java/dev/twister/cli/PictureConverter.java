package dev.twister.cli;

import dev.twister.world.Picture;
import java.util.List;
import java.util.stream.Collectors;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads the name of a stage or of a view, in small or capital letters. */
final class PictureConverter {
    private PictureConverter() {}

    static final class OfStage implements ITypeConverter<Picture> {
        @Override
        public Picture convert(String text) {
            return find(text, Picture.stages());
        }
    }

    static final class OfView implements ITypeConverter<Picture> {
        @Override
        public Picture convert(String text) {
            return find(text, Picture.views());
        }
    }

    private static Picture find(String text, List<Picture> choices) {
        return choices.stream()
                .filter(choice -> choice.id().equalsIgnoreCase(text))
                .findFirst()
                .orElseThrow(() -> new TypeConversionException("unknown value '" + text + "'; expected one of: "
                        + choices.stream().map(Picture::id).collect(Collectors.joining(", "))));
    }
}
