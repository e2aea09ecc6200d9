package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The example program in README runs unchanged. */
class ReadmeExampleTest {
    private static final Pattern EXAMPLE = Pattern.compile("```java\\n(.*?class (\\w+).*?)```", Pattern.DOTALL);

    @TempDir
    private Path folder;

    @Test
    void exampleRendersItsPicture() throws IOException, InterruptedException {
        MatchResult example = EXAMPLE.matcher(Files.readString(Path.of("README.md")))
                .results()
                .findFirst()
                .orElseThrow();
        Path source = Files.writeString(folder.resolve(example.group(2) + ".java"), example.group(1));

        // The JVM compiles and runs single-file programs.
        Process java = ChildJvm.start(new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        source.toString())
                .directory(folder.toFile())
                .redirectErrorStream(true));

        assertThat(new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
                .isEmpty();
        assertThat(java.waitFor()).isZero();
        BufferedImage picture = ImageIO.read(folder.resolve("balls.png").toFile());
        assertThat(picture.getWidth()).isEqualTo(1280);
        assertThat(picture.getRGB(640, 700)).isNotEqualTo(picture.getRGB(640, 10));
    }
}
