package dev.twister.cli.file;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.cli.Main;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Starts Twister as a separate process without a display, as on a server. */
class NoDisplayTest {
    @Test
    @EnabledOnOs(OS.LINUX)
    void withoutADisplayOneLineNamesWhatNeedsNone() throws IOException {
        assertOneLine("DISPLAY is not set", "");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void aDisplayThatIsNotThereIsTheSame() throws IOException {
        assertOneLine("no window can be opened", "nowhere:99");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void aPanoramaIsOpenedInTheWindowAsAScenesSky() throws IOException {
        assertOneLine(
                "DISPLAY is not set", "", Path.of("skyboxes", "sunset.hdr").toString());
    }

    private static void assertOneLine(String why, String display, String... opened) throws IOException {
        ProcessBuilder start = new ProcessBuilder(Stream.of(
                                Path.of(System.getProperty("java.home"), "bin", "java")
                                        .toString(),
                                "--enable-native-access=ALL-UNNAMED",
                                "-cp",
                                System.getProperty("java.class.path"),
                                Main.class.getName(),
                                "gui")
                        .collect(Collectors.toCollection(ArrayList::new)))
                .redirectErrorStream(true);
        start.command().addAll(List.of(opened));
        start.environment().put("DISPLAY", display);
        Process twister = start.start();
        try (Stream<String> lines = twister.inputReader().lines()) {
            assertThat(lines.toList()).singleElement().asString().contains(why, "twister render", "twister benchmark");
        }
        assertThat(twister.onExit().join().exitValue()).isEqualTo(ExitCode.BAD_INPUT);
    }
}
