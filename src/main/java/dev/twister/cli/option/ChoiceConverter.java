package dev.twister.cli.option;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.TypeConversionException;

/**
 * Reads one of some names, in small or capital letters. The library's own tells the user how Java spells them.
 *
 * @param choices the constants of an enum
 */
public record ChoiceConverter(List<? extends Enum<?>> choices) implements ITypeConverter<Enum<?>> {
    /**
     * Lets all options of a command whose values are constants, and that have no converter, read their names, and lets
     * shells offer these.
     */
    public static void applyTo(CommandSpec command) {
        for (OptionSpec option : List.copyOf(command.options())) {
            Class<?> type = option.auxiliaryTypes()[0];
            if (type.isEnum() && option.converters().length == 0) {
                ChoiceConverter converter = new ChoiceConverter(Stream.of(type.getEnumConstants())
                        .<Enum<?>>map(constant -> (Enum<?>) constant)
                        .toList());
                command.remove(option);
                command.addOption(OptionSpec.builder(option)
                        .converters(converter)
                        .completionCandidates(converter.names())
                        .build());
            }
        }
    }

    @Override
    public Enum<?> convert(String text) {
        return choices.stream()
                .filter(choice -> choice.name().equalsIgnoreCase(text))
                .findFirst()
                .orElseThrow(() -> new TypeConversionException(
                        "unknown value '" + text + "'; expected one of: " + String.join(", ", names())));
    }

    /** As a user is told them. */
    private List<String> names() {
        return choices.stream()
                .map(choice -> choice.name().toLowerCase(Locale.ROOT))
                .toList();
    }
}
