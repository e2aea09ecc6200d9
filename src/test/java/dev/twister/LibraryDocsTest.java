package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The examples of docs/library.md compile. */
class LibraryDocsTest {
    private static final Pattern EXAMPLE = Pattern.compile("```java\\n(.*?)```", Pattern.DOTALL);

    @TempDir
    private Path folder;

    @Test
    void examplesCompile() throws IOException {
        StringBuilder source = new StringBuilder();
        for (String name : List.of(
                "dev.twister",
                "dev.twister.denoise",
                "dev.twister.engine",
                "dev.twister.image",
                "dev.twister.scene",
                "dev.twister.scene.format",
                "dev.twister.world",
                "java.awt.image",
                "java.nio.file",
                "java.util",
                "java.util.concurrent.atomic")) {
            source.append("import ").append(name).append(".*;\n");
        }
        source.append("class Examples {\n");
        List<MatchResult> examples = EXAMPLE.matcher(Files.readString(Path.of("docs", "library.md")))
                .results()
                .toList();
        for (int index = 0; index < examples.size(); index++) {
            source.append("void example")
                    .append(index)
                    .append("(SceneBuilder scene, SceneBuilder builder) throws Exception {\n")
                    .append(examples.get(index).group(1))
                    .append("}\n");
        }
        Path file = Files.writeString(folder.resolve("Examples.java"), source.append("}\n"));
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter errors = new StringWriter();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
            compiler.getTask(
                            errors,
                            files,
                            null,
                            List.of("-d", folder.toString(), "-proc:none", "-cp", System.getProperty("java.class.path")),
                            null,
                            files.getJavaFileObjects(file))
                    .call();
        }
        assertThat(examples).hasSizeGreaterThan(4);
        assertThat(errors.toString()).isEmpty();
    }
}
