package dev.twister.cli.command;

import dev.twister.cli.file.ExitCode;
import dev.twister.cli.manual.ManPage;
import dev.twister.cli.manual.ShellCompletion;
import dev.twister.files.WholeFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code twister package-files}: what a package installs for {@code man} and for shells. */
@Command(
        name = "package-files",
        hidden = true,
        description = "Writes the manual page, and the completion files of bash, zsh and fish.")
final class PackageFilesCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "DIR", description = "An existing folder; they go to their places below share in it.")
    private Path folder;

    @Override
    public Integer call() throws IOException {
        CommandLine twister = spec.root().commandLine();
        write("man/man1/twister.1", ManPage.of(twister));
        write("bash-completion/completions/twister", AutoComplete.bash("twister", twister));
        write("zsh/vendor-completions/_twister", ShellCompletion.zsh(twister.getCommandSpec()));
        write("fish/vendor_completions.d/twister.fish", ShellCompletion.fish(twister.getCommandSpec()));
        return ExitCode.OK;
    }

    private void write(String place, String text) throws IOException {
        Path file = folder.resolve("share").resolve(place);
        Files.createDirectories(file.getParent());
        WholeFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
}
