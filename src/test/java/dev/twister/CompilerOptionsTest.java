package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** Options for the JVM's compiler name existing methods only: the JVM does not report unknown ones. */
final class CompilerOptionsTest {
    private static final Pattern COMMANDED = Pattern.compile("CompileCommand=\\w+,([\\w/]+(?:/\\*)?)\\.([\\w*]+)");

    @TestFactory
    Stream<DynamicTest> namesMethods() throws IOException {
        String options = Files.readString(Path.of("scripts", "engine.options"));
        List<MatchResult> commanded = COMMANDED.matcher(options).results().toList();
        assertThat(commanded)
                .hasSameSizeAs(options.lines()
                        .filter(line -> line.startsWith("-XX:CompileCommand=") && !line.endsWith("quiet"))
                        .toList());
        return commanded.stream()
                .map(result -> DynamicTest.dynamicTest(
                        result.group(1) + "." + result.group(2),
                        () -> assertThat(methods(result.group(1)))
                                .anyMatch(glob(result.group(2)).asMatchPredicate())));
    }

    /** Returns the method names of a class or of all classes of a package. */
    private static List<String> methods(String classes) throws IOException {
        String folder = classes.substring(0, classes.lastIndexOf('/'));
        String name = classes.substring(classes.lastIndexOf('/') + 1) + ".class";
        try (Stream<Path> files = Files.list(folder(folder))) {
            return files.map(file -> file.getFileName().toString())
                    .filter(glob(name).asMatchPredicate())
                    .flatMap(file -> methods(folder, file))
                    .toList();
        }
    }

    private static Stream<String> methods(String folder, String file) {
        String name = folder.replace('/', '.') + "." + file.substring(0, file.length() - ".class".length());
        try {
            return Arrays.stream(Class.forName(name, false, CompilerOptionsTest.class.getClassLoader())
                            .getDeclaredMethods())
                    .map(method -> method.getName());
        } catch (ClassNotFoundException e) {
            throw new AssertionError(e);
        }
    }

    private static Path folder(String name) {
        return Stream.of(Path.of("target", "classes", name), jdk("jdk.incubator.vector", name), jdk("java.base", name))
                .filter(Files::isDirectory)
                .findFirst()
                .orElseThrow(() -> new AssertionError("there is no package " + name));
    }

    private static Path jdk(String module, String name) {
        return FileSystems.getFileSystem(URI.create("jrt:/")).getPath("modules", module, name);
    }

    private static Pattern glob(String text) {
        return Pattern.compile(text.replace(".", "\\.").replace("*", ".*"));
    }
}
