package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.OutputFile;
import dev.twister.denoise.DenoiserOffer;
import dev.twister.denoise.Denoisers;
import dev.twister.render.Finishing;
import dev.twister.world.StageOrView;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Options for removing noise. */
public final class DenoisingOptions {
    @Option(
            names = "--denoise",
            description =
                    "Remove the noise by the library Open Image Denoise, see 'twister devices'. An .exr file keeps the"
                            + " noisy picture and the guides as layers.")
    private boolean denoise;

    @Option(
            names = "--guides",
            description =
                    "Add the guides of denoising to an .exr file: albedo and normal behind mirrors and clear glass,"
                            + " for 'twister denoise' and 'twister join --denoise'.")
    private boolean guides;

    @Option(
            names = "--light-layers",
            description = "Add the light of each group of lights, and the guides, to an .exr file, for 'twister join"
                    + " --light'.")
    private boolean lightLayers;

    public boolean isOn() {
        return denoise;
    }

    /** Rejects options that exclude denoising. */
    public void check(Path output, List<StageOrView> pictures, PartOptions part) {
        if ((denoise || guides || lightLayers) && pictures.stream().noneMatch(Finishing::isFull)) {
            throw new BadInputException((denoise ? "--denoise" : layersOption())
                    + " needs the full picture; add the view beauty, or leave --stage and --view out");
        }
        if (denoise && part.areGiven()) {
            throw new BadInputException(
                    "--denoise needs the whole picture; give --guides here, and --denoise to" + " 'twister join'");
        }
        if ((guides || lightLayers) && !OutputFile.endsIn(output, ".exr")) {
            throw new BadInputException("--output is " + output + ", but " + layersOption() + " needs an .exr file");
        }
    }

    private String layersOption() {
        return lightLayers ? "--light-layers" : "--guides";
    }

    /**
     * What the options ask for.
     *
     * @throws dev.twister.denoise.DenoiseException if there is no denoiser
     */
    public Finishing finishing(boolean autoExposure) {
        return new Finishing(autoExposure, guides, lightLayers, denoise ? Optional.of(offer()) : Optional.empty());
    }

    private static DenoiserOffer offer() {
        DenoiserOffer offer = Denoisers.offer();
        offer.check();
        return offer;
    }
}
