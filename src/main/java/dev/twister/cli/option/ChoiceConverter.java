package dev.twister.cli.option;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads one of some names, in small or capital letters. The library's own tells the user how Java spells them. */
public record ChoiceConverter<E extends Enum<E>>(Class<E> choices) implements ITypeConverter<E> {
    @Override
    public E convert(String text) {
        return Stream.of(choices.getEnumConstants())
                .filter(choice -> choice.name().equalsIgnoreCase(text))
                .findFirst()
                .orElseThrow(() -> new TypeConversionException(
                        "unknown value '" + text + "'; expected one of: " + String.join(", ", names(choices))));
    }

    /** As a user is told them. */
    static <E extends Enum<E>> List<String> names(Class<E> choices) {
        return Stream.of(choices.getEnumConstants())
                .map(choice -> choice.name().toLowerCase(Locale.ROOT))
                .toList();
    }
}
