package dev.twister.cli.file;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.cli.Outcome;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PackageFilesTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void write() {
        assertThat(Outcome.of("package-files", folder.toString())).isEqualTo(new Outcome(ExitCode.OK, "", ""));
    }

    @Test
    void theManualPageHasCommandsOptionsAndExamples() throws IOException {
        assertThat(read("man/man1/twister.1"))
                .startsWith(".TH TWISTER 1\n.SH NAME\ntwister \\- a real\\-time ray tracer")
                .contains("\n.SS twister render SCENE\n", "\n\\fB\\-\\-tone\\-map\\fR \\fIMAP\\fR\n")
                .contains("\n.EX\ntwister benchmark \\-\\-quick")
                .doesNotContain("package\\-files", "${", "@|");
    }

    @Test
    void fishAndZshKnowTheOptionsAndTheirValues() throws IOException {
        assertThat(read("fish/vendor_completions.d/twister.fish"))
                .contains("__fish_seen_subcommand_from render' -l tone-map -r -f -a 'clamp reinhard aces' -d ")
                .contains("__fish_use_subcommand -f -a render -d 'Renders a scene")
                .doesNotContain("package-files");
        assertThat(read("zsh/vendor-completions/_twister"))
                .startsWith("#compdef twister\n")
                .contains("'--tone-map[clamp, reinhard or aces]:MAP:(clamp reinhard aces)'")
                .contains("'render:Renders a scene");
    }

    private String read(String place) throws IOException {
        return Files.readString(folder.resolve("share").resolve(place));
    }
}
