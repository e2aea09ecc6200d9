package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Distributed files include Twister's license and those of its libraries. */
class LicensesTest {
    private static final Path LIST = Path.of("THIRD-PARTY.txt");
    private static final Pattern LIBRARY =
            Pattern.compile("[a-z.-]+:(?<name>[a-z0-9-]+):(?<version>[0-9.]+)  (?<license>.+)");

    @Test
    void everyLibraryIsListed() throws IOException {
        String libraries = Files.readString(Path.of("target", "runtime.classpath"));
        Set<String> built = Pattern.compile(File.pathSeparator, Pattern.LITERAL)
                .splitAsStream(libraries.strip())
                .map(Path::of)
                // A library with native code has one more jar for each system.
                .map(jar -> jar.getParent().getParent().getFileName() + " "
                        + jar.getParent().getFileName())
                .collect(Collectors.toSet());

        assertThat(listed().stream()
                        .map(LIBRARY::matcher)
                        .filter(Matcher::matches)
                        .map(library -> library.group("name") + " " + library.group("version")))
                .containsExactlyInAnyOrderElementsOf(built);
    }

    @Test
    void everyLicenseIsExplained() throws IOException {
        List<String> lines = listed();
        assertThat(lines.stream()
                        .map(LIBRARY::matcher)
                        .filter(Matcher::matches)
                        .map(library -> library.group("license") + ": "))
                .allSatisfy(license -> assertThat(lines).anyMatch(line -> line.startsWith(license)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"LICENSE", "NOTICE", "THIRD-PARTY.txt"})
    void theJarHasThem(String name) throws IOException {
        assertThat(Path.of("target", "classes", "META-INF", name)).hasSameTextualContentAs(Path.of(name));
    }

    private static List<String> listed() throws IOException {
        return Files.readAllLines(LIST);
    }
}
