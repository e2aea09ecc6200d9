package dev.twister.cli.manual;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** What the commands and their options say of themselves, as plain text. */
final class CommandTexts {
    private CommandTexts() {}

    /** The commands but for hidden ones, in the order of the help. */
    static List<CommandSpec> commands(CommandSpec twister) {
        return twister.subcommands().values().stream()
                .map(CommandLine::getCommandSpec)
                .filter(command -> !command.usageMessage().hidden())
                .toList();
    }

    /** The options by name, but for hidden ones. */
    static List<OptionSpec> options(CommandSpec command) {
        return command.options().stream()
                .filter(option -> !option.hidden())
                .sorted(Comparator.comparing(OptionSpec::longestName))
                .toList();
    }

    static String parameters(CommandSpec command) {
        return command.positionalParameters().stream()
                .map(PositionalParamSpec::paramLabel)
                .collect(Collectors.joining(" "));
    }

    static String description(CommandSpec command) {
        return plain(String.join(" ", command.usageMessage().description()));
    }

    static String text(ArgSpec argument) {
        return plain(String.join(" ", argument.description()));
    }

    /** The first sentence. */
    static String summary(String text) {
        int end = text.indexOf(". ");
        return end < 0 ? text.replaceFirst("\\.$", "") : text.substring(0, end);
    }

    private static String plain(String text) {
        return Ansi.OFF.string(text).replaceAll("\\s+", " ").strip();
    }
}
