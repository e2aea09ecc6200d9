package dev.twister.cli.manual;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.StreamSupport;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** Completion of commands, options and their values in the shells that picocli does not know. */
public final class ShellCompletion {
    private ShellCompletion() {}

    /** A file for fish's {@code vendor_completions.d}. */
    public static String fish(CommandSpec twister) {
        List<String> lines = new ArrayList<>();
        for (CommandSpec command : CommandTexts.commands(twister)) {
            lines.add("complete -c twister -n __fish_use_subcommand -f -a " + command.name() + " -d "
                    + quoted(CommandTexts.summary(CommandTexts.description(command))));
            String inCommand = "complete -c twister -n '__fish_seen_subcommand_from " + command.name() + "'";
            command.positionalParameters().stream()
                    .filter(parameter -> !values(parameter).isEmpty())
                    .forEach(parameter -> lines.add(inCommand + " -a " + quoted(values(parameter))));
            for (OptionSpec option : CommandTexts.options(command)) {
                String values = values(option);
                lines.add(inCommand
                        + Arrays.stream(option.names())
                                .map(name ->
                                        name.startsWith("--") ? " -l " + name.substring(2) : " -s " + name.substring(1))
                                .collect(Collectors.joining())
                        + (option.arity().max() == 0 ? "" : " -r")
                        + (values.isEmpty() ? "" : " -f -a " + quoted(values))
                        + " -d " + quoted(CommandTexts.summary(CommandTexts.text(option))));
            }
        }
        return String.join("\n", lines) + "\n";
    }

    /** A file called {@code _twister} for a folder of zsh's {@code fpath}. */
    public static String zsh(CommandSpec twister) {
        List<String> lines = new ArrayList<>(List.of("#compdef twister", "", "local -a commands", "commands=("));
        for (CommandSpec command : CommandTexts.commands(twister)) {
            lines.add("    "
                    + quoted(command.name() + ":"
                            + CommandTexts.summary(CommandTexts.description(command))
                                    .replace(":", "\\:")));
        }
        lines.addAll(List.of(
                ")",
                "if (( CURRENT == 2 )); then",
                "    _describe command commands",
                "    return",
                "fi",
                "local command=$words[2]",
                "shift words",
                "(( CURRENT-- ))",
                "case $command in"));
        for (CommandSpec command : CommandTexts.commands(twister)) {
            lines.add("    " + command.name() + ")");
            lines.add("        _arguments \\");
            for (OptionSpec option : CommandTexts.options(command)) {
                for (String name : option.names()) {
                    lines.add("            " + quoted(name + "[" + inBrackets(option) + "]" + value(option)) + " \\");
                }
            }
            String scenes = command.positionalParameters().stream()
                    .map(ShellCompletion::values)
                    .collect(Collectors.joining(" "))
                    .strip();
            lines.add("            "
                    + quoted(scenes.isEmpty() ? "*:file:_files" : "*:scene:{ compadd " + scenes + "; _files }"));
            lines.add("        ;;");
        }
        lines.add("esac");
        return String.join("\n", lines) + "\n";
    }

    private static String inBrackets(OptionSpec option) {
        return CommandTexts.summary(CommandTexts.text(option))
                .replace("\\", "\\\\")
                .replace("[", "\\[")
                .replace("]", "\\]")
                .replace(":", "\\:");
    }

    private static String value(OptionSpec option) {
        if (option.arity().max() == 0) {
            return "";
        }
        String values = values(option);
        return ":" + option.paramLabel().replace(":", "\\:") + ":" + (values.isEmpty() ? "_files" : "(" + values + ")");
    }

    private static String values(ArgSpec argument) {
        Iterable<String> candidates = argument.completionCandidates();
        return candidates == null
                ? ""
                : StreamSupport.stream(candidates.spliterator(), false).collect(Collectors.joining(" "));
    }

    private static String quoted(String text) {
        return "'" + text.replace("'", "'\\''") + "'";
    }
}
