package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.image.PngWriter;
import dev.twister.scene.Rendering;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The shipped scenes as last approved by a person, in {@code src/test/resources/golden}.
 *
 * <p>After an intended change, {@code ./mvnw -Dtest=GoldenPicturesTest -Dtwister.golden.update=true package} updates a
 * picture; look at it before committing. On failure, the actual picture and the difference times eight are in
 * {@code target/golden}.
 */
class GoldenPicturesTest {
    private static final Path GOLDEN = Path.of("src/test/resources/golden");
    private static final Path ACTUAL = Path.of("target/golden");

    /** Makes differences of a few 255ths visible. */
    private static final int DIFFERENCE_GAIN = 8;

    static List<String> names() {
        return ShippedScenes.names();
    }

    @ParameterizedTest
    @MethodSource("names")
    void pictureIsAsItWas(String name) throws IOException {
        LitScene small = ShippedScenes.small(name);
        Rendering settings = small.scene().rendering();
        int[] actual = Pictures.argb(JvmEngines.PARALLEL, small);
        Path golden = GOLDEN.resolve(name + ".png");
        if (Boolean.getBoolean("twister.golden.update")) {
            write(golden, settings, actual);
        }
        BufferedImage expected = ImageIO.read(golden.toFile());
        assertThat(expected.getWidth()).isEqualTo(settings.width());
        assertThat(expected.getHeight()).isEqualTo(settings.height());
        int[] pixels = expected.getRGB(0, 0, settings.width(), settings.height(), null, 0, settings.width());
        PictureDifference difference = PictureDifference.between(actual, pixels);
        if (!difference.isWithinBound()) {
            write(ACTUAL.resolve(name + ".png"), settings, actual);
            write(ACTUAL.resolve(name + "-difference.png"), settings, enlarged(actual, pixels));
        }
        assertThat(difference)
                .as("%s; look at %s", name, ACTUAL)
                .matches(PictureDifference::isWithinBound, "is within the design's bound");
    }

    private static int[] enlarged(int[] actual, int[] expected) {
        int[] differences = new int[actual.length];
        Arrays.setAll(differences, pixel -> {
            int gray = Math.min(
                    255, DIFFERENCE_GAIN * PictureDifference.channelDifference(actual[pixel], expected[pixel]));
            return 0xFF000000 | gray << 16 | gray << 8 | gray;
        });
        return differences;
    }

    private static void write(Path file, Rendering settings, int[] argb) throws IOException {
        Files.createDirectories(file.getParent());
        PngWriter.write(file, settings.width(), settings.height(), argb, settings.srgb());
    }
}
