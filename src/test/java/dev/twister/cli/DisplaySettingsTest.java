package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.denoise.FakeDenoiser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Exposure and tone map travel with linear files. */
class DisplaySettingsTest {
    private static final String[] LOOK = {"--exposure", "-1.7", "--tone-map", "aces"};

    @TempDir
    private Path folder;

    @Test
    void aJoinedPictureLooksAsIfRendered() throws IOException {
        int[] rendered = render("a.png", LOOK);
        render("a.exr", LOOK);
        run("join", file("a.exr"), "-o", file("b.exr"));
        run("join", file("b.exr"), "-o", file("b.png"));

        assertThat(pixels("b.png")).isEqualTo(rendered);
    }

    @Test
    void optionsOverrideTheFile() throws IOException {
        int[] rendered = render("a.png", "--exposure", "1", "--tone-map", "reinhard");
        render("a.exr", LOOK);
        run("join", file("a.exr"), "-o", file("b.png"), "--exposure", "1", "--tone-map", "reinhard");

        assertThat(pixels("b.png")).isEqualTo(rendered);
    }

    @Test
    void aDenoisedPictureKeepsThem() throws IOException {
        System.setProperty(FakeDenoiser.PROPERTY, "true");
        try {
            render("a.exr", LOOK);
            run("denoise", file("a.exr"), "-o", file("b.png"));
            run("denoise", file("a.exr"), "-o", file("c.png"), "--exposure", "-1.7", "--tone-map", "aces");
        } finally {
            System.clearProperty(FakeDenoiser.PROPERTY);
        }

        assertThat(Files.readAllBytes(folder.resolve("b.png"))).isEqualTo(Files.readAllBytes(folder.resolve("c.png")));
    }

    private int[] render(String output, String... look) throws IOException {
        String[] command = {"render", "cornell", "--engine", "sequential", "--size", "12x12", "-o", file(output)};
        String[] all = Arrays.copyOf(command, command.length + look.length);
        System.arraycopy(look, 0, all, command.length, look.length);
        run(all);
        return output.endsWith(".png") ? pixels(output) : new int[0];
    }

    private static void run(String... arguments) {
        assertThat(Outcome.of(arguments).exitCode()).isZero();
    }

    private int[] pixels(String name) throws IOException {
        return ImageIO.read(folder.resolve(name).toFile()).getRGB(0, 0, 12, 12, null, 0, 12);
    }

    private String file(String name) {
        return folder.resolve(name).toString();
    }
}
