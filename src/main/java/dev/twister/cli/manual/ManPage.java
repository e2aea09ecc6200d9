package dev.twister.cli.manual;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** The manual page of all commands, as source for {@code man}, made of what {@code --help} says. */
public final class ManPage {
    private final List<String> lines = new ArrayList<>();

    private ManPage() {}

    /**
     * The page's text.
     *
     * @param twister the command line with all commands
     */
    public static String of(CommandLine twister) {
        ManPage page = new ManPage();
        CommandSpec spec = twister.getCommandSpec();
        String what = CommandTexts.description(spec);
        page.lines.add(".TH TWISTER 1");
        page.section(
                "NAME",
                "twister \\- "
                        + escaped(what.substring(0, 1).toLowerCase(Locale.ROOT)
                                + what.substring(1).replaceFirst("\\.$", "")));
        page.section("SYNOPSIS", ".B twister\n[\\fICOMMAND\\fR] [\\fIOPTIONS\\fR]");
        page.section("DESCRIPTION", escaped(what + " Without a command, it opens the window."));
        page.lines.add(".SH COMMANDS");
        CommandTexts.commands(spec).forEach(page::command);
        page.lines.add(".SH EXIT STATUS");
        page.item("\\fB0\\fR", "Done.");
        page.item("\\fB1\\fR", "An engine failed, rendered a different picture, or is slower than it was.");
        page.item("\\fB2\\fR", "Bad input, or output that cannot be written.");
        page.item("\\fB130, 143\\fR", "Stopped by Ctrl+C, or by a TERM signal.");
        return String.join("\n", page.lines) + "\n";
    }

    private void section(String title, String text) {
        lines.add(".SH " + title);
        lines.add(text);
    }

    private void command(CommandSpec command) {
        lines.add(".SS twister " + escaped(command.name() + " " + CommandTexts.parameters(command)));
        lines.add(escaped(CommandTexts.description(command)));
        command.positionalParameters()
                .forEach(parameter ->
                        item("\\fI" + escaped(parameter.paramLabel()) + "\\fR", CommandTexts.text(parameter)));
        CommandTexts.options(command).forEach(option -> item(heading(option), CommandTexts.text(option)));
        String[] examples = command.usageMessage().footer();
        Arrays.stream(examples)
                .map(example -> example.replaceAll("@\\|\\w+ |\\|@", "").strip())
                .filter(example -> example.startsWith("twister "))
                .forEach(example -> lines.add(".PP\n.EX\n" + escaped(example) + "\n.EE"));
    }

    private static String heading(OptionSpec option) {
        String names = Arrays.stream(option.names())
                .map(name -> "\\fB" + escaped(name) + "\\fR")
                .collect(Collectors.joining(", "));
        return option.arity().max() == 0 ? names : names + " \\fI" + escaped(option.paramLabel()) + "\\fR";
    }

    private void item(String heading, String text) {
        lines.add(".TP");
        lines.add(heading);
        lines.add(escaped(text));
    }

    /** A line that begins with a dot or a quote would be a request. */
    private static String escaped(String text) {
        String safe = text.replace("\\", "\\e").replace("-", "\\-");
        return safe.startsWith(".") || safe.startsWith("'") ? "\\&" + safe : safe;
    }
}
