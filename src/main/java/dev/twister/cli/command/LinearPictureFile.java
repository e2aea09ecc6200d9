package dev.twister.cli.command;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.option.ToneOptions;
import dev.twister.engine.AutoExposure;
import dev.twister.image.AlphaChannel;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrWriter;
import dev.twister.image.HdrWriter;
import dev.twister.image.PngWriter;
import dev.twister.image.Provenance;
import dev.twister.render.FileDisplay;
import dev.twister.render.PictureLayers;
import dev.twister.scene.Rendering;
import dev.twister.world.TonedPixels;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Writes a picture that was read from .exr files. */
final class LinearPictureFile {
    private LinearPictureFile() {}

    /** Rejects files of other formats, and places where nothing can be written. */
    static void check(Path output) {
        if (!OutputFile.isStandardOutput(output)
                && List.of(".exr", ".hdr", ".png").stream().noneMatch(ending -> OutputFile.endsIn(output, ending))) {
            throw new BadInputException(
                    "--output is " + output + ", but must end in .exr, .hdr or .png, or be - for a PNG");
        }
        OutputFile.checkBinary("--output", output);
    }

    /**
     * Writes all channels to an .exr file, and the colors to a .hdr or .png file.
     *
     * @param tone overrides the file's own exposure and tone map, for a .png file
     */
    static void write(Path output, ExrPicture picture, ToneOptions tone) throws IOException {
        Provenance made = picture.provenance().orElseThrow();
        if (OutputFile.endsIn(output, ".exr")) {
            ExrWriter.write(output, picture);
        } else if (OutputFile.endsIn(output, ".hdr")) {
            HdrWriter.write(output, picture.width(), picture.height(), radiance(picture), made);
        } else {
            Optional<AlphaChannel> alpha = AlphaChannel.of(picture);
            float[] colors = radiance(picture);
            float[] radiance = alpha.map(channel -> channel.straight(colors)).orElse(colors);
            Rendering settings = tone.over(FileDisplay.settings(Optional.of(made)));
            int[] pixels = TonedPixels.of(
                    radiance, tone.metered(settings, () -> AutoExposure.stops(radiance, settings.srgb())));
            alpha.ifPresent(channel -> channel.put(pixels));
            PngWriter.write(
                    output, picture.width(), picture.height(), pixels, settings.srgb(), alpha.isPresent(), made);
        }
    }

    private static float[] radiance(ExrPicture picture) {
        return PictureLayers.of(picture, PictureLayers.COLORS)
                .orElseThrow(() -> new BadInputException(
                        "the picture has no colors, only numbers; give an .exr file as --output"));
    }
}
