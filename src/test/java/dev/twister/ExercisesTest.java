package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The checks of the lessons' exercises pass the solutions, and not the starting text. */
class ExercisesTest {
    private static final Path FOLDER = Path.of("examples", "exercises");

    @TempDir
    private Path folder;

    @Tag("slow")
    @Test
    void checksPassSolutionsAlone() throws IOException, InterruptedException {
        List<String> sources;
        try (Stream<Path> files = Files.list(FOLDER)) {
            sources = files.map(Path::toString)
                    .filter(file -> file.endsWith(".java"))
                    .toList();
        }
        List<String> options = Stream.concat(
                        Stream.of("-d", folder.toString(), "-proc:none", "-Xlint:all", "-Werror"), sources.stream())
                .toList();
        assertThat(ToolProvider.getSystemJavaCompiler().run(null, null, null, options.toArray(String[]::new)))
                .isZero();

        for (String exercise : List.of("ToneMap", "Shape", "Light")) {
            assertThat(exitCode("Check" + exercise)).as(exercise).isEqualTo(1);
            assertThat(exitCode("Check" + exercise, "solution")).as(exercise).isZero();
        }
    }

    private int exitCode(String... command) throws IOException, InterruptedException {
        Path java = Path.of(System.getProperty("java.home"), "bin", "java");
        List<String> words = Stream.concat(
                        Stream.of(java.toString(), "-XX:TieredStopAtLevel=1", "-cp", classPath()), Stream.of(command))
                .toList();
        return ChildJvm.start(new ProcessBuilder(words)
                        .directory(folder.toFile())
                        .redirectErrorStream(true)
                        .redirectOutput(ProcessBuilder.Redirect.DISCARD))
                .waitFor();
    }

    private String classPath() {
        String own = Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
                .map(entry -> Path.of(entry).toAbsolutePath().toString())
                .collect(Collectors.joining(File.pathSeparator));
        return folder + File.pathSeparator + own;
    }
}
