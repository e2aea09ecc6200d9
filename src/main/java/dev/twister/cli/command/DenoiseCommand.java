package dev.twister.cli.command;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.file.SizeCheck;
import dev.twister.cli.option.ToneOptions;
import dev.twister.cli.progress.DenoisingNotes;
import dev.twister.denoise.Denoiser;
import dev.twister.denoise.Denoisers;
import dev.twister.files.InputFile;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrReader;
import dev.twister.image.ExrReader.ExrExtent;
import dev.twister.image.PictureSize;
import dev.twister.render.DenoisedPicture;
import dev.twister.scene.Rendering;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code twister denoise}: removes the noise of a picture. */
@Command(
        name = "denoise",
        description = "Removes the noise of a picture by the library Open Image Denoise; 'twister devices' says whether"
                + " it is there.",
        footer = {
            "",
            "Examples:",
            "  twister denoise noisy.exr -o clean.exr",
            "  twister denoise noisy.exr -o clean.png --exposure 1"
        })
final class DenoiseCommand implements Callable<Integer> {
    /** Colors and guides; files with more layers are checked by their reader. */
    private static final long USUAL_CHANNELS = 9;

    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "FILE",
            description = "An .exr file from 'twister render', best with --guides, or from 'twister join'.")
    private Path file;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "The picture: .exr keeps all layers, with the noisy picture as layer 'noisy'; .hdr and .png"
                    + " keep the colors; - writes a PNG to standard output.")
    private Path output;

    @Mixin
    private ToneOptions tone;

    @Override
    public Integer call() throws IOException {
        LinearPictureFile.check(output);
        tone.over(Rendering.DEFAULT);
        InputFile.problem(file).ifPresent(problem -> {
            throw new BadInputException(file + ": " + problem);
        });
        OutputFile.checkKeeps("--output", output, List.of(file));
        ExrExtent extent = ExrReader.extent(file);
        if (extent.rows() < extent.height()) {
            throw new BadInputException(file + " has rows " + extent.firstRow() + " to "
                    + (extent.firstRow() + extent.rows() - 1) + " of " + extent.height()
                    + "; 'twister join' makes a picture of such parts");
        }
        SizeCheck.check(
                "the picture",
                new PictureSize(extent.width(), extent.height()),
                Float.BYTES * USUAL_CHANNELS + DenoisedPicture.BYTES_PER_PIXEL);
        DenoisedPicture denoised;
        try (Denoiser denoiser = Denoisers.open()) {
            denoised = denoised(denoiser);
        }
        DenoisingNotes.print(denoised, file.toString(), spec.commandLine().getErr());
        ExrPicture picture = denoised.picture();
        LinearPictureFile.write(output, picture, tone);
        OutputFile.notes(spec.commandLine(), output)
                .printf("%s: %d x %d, denoised%n", OutputFile.name(output), picture.width(), picture.height());
        return ExitCode.OK;
    }

    private DenoisedPicture denoised(Denoiser denoiser) throws IOException {
        ExrPicture picture = ExrReader.read(file);
        if (picture.provenance().isEmpty()) {
            throw new BadInputException(file + " does not say how it was made; it must be from 'twister render'");
        }
        try {
            return DenoisedPicture.of(picture, denoiser);
        } catch (IllegalArgumentException problem) {
            throw new BadInputException(file + " " + problem.getMessage());
        }
    }
}
