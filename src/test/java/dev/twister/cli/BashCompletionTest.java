package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

class BashCompletionTest {
    @TempDir
    private Path folder;

    /** A question to bash, and the answer. */
    private record Offered(String command, String option, String values) {
        String question() {
            return "COMPREPLY=(); COMP_WORDS=(twister " + command + " " + option + " ''); COMP_CWORD=3; "
                    + "_complete_twister; echo " + command + " " + option + " ${COMPREPLY[*]}";
        }

        String answer() {
            return command + " " + option + " " + values;
        }
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void eachOptionOffersItsOwnValues() throws Exception {
        PrintWriter nowhere = new PrintWriter(Writer.nullWriter());
        CommandLine twister = Main.commandLine(nowhere, nowhere);
        List<Offered> all = twister.getSubcommands().values().stream()
                .map(CommandLine::getCommandSpec)
                .filter(command -> !command.usageMessage().hidden())
                .flatMap(BashCompletionTest::offered)
                .toList();
        Path script = folder.resolve("ask");
        Files.writeString(
                script,
                AutoComplete.bash("twister", twister)
                        // Works only where a person types.
                        + "\ncompopt() { :; }\n"
                        + all.stream().map(Offered::question).collect(Collectors.joining("\n")));

        Process bash = new ProcessBuilder("bash", script.toString())
                .redirectErrorStream(true)
                .start();

        assertThat(bash.inputReader().lines())
                .containsExactlyElementsOf(all.stream().map(Offered::answer).toList())
                .contains("render --integrator whitted path", "render --background sky none", "render --up y z");
    }

    private static Stream<Offered> offered(CommandSpec command) {
        return command.options().stream()
                .filter(option -> option.completionCandidates() != null)
                .map(option -> new Offered(command.name(), option.longestName(), values(option)));
    }

    private static String values(OptionSpec option) {
        return StreamSupport.stream(option.completionCandidates().spliterator(), false)
                .collect(Collectors.joining(" "));
    }
}
