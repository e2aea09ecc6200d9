package dev.twister.cli;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.files.TwisterVersion;
import dev.twister.image.Provenance;
import dev.twister.world.FrameDigest;
import dev.twister.world.FrameInput;
import dev.twister.world.Picture;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** Draws pictures one after the other as options have them. The engine is opened with the first one. */
final class PictureDrawing implements AutoCloseable {
    private final String engineId;
    private final List<Picture> pictures;
    private final Sampling sampling;
    private final PartOptions part;
    private final boolean linear;
    private final FrameDigest digest = new FrameDigest();
    private Optional<Engine> engine = Optional.empty();

    /**
     * Draws nothing yet.
     *
     * @param pictures what is drawn of each
     * @param linear whether colors are wanted as radiance
     */
    PictureDrawing(String engineId, List<Picture> pictures, Sampling sampling, PartOptions part, boolean linear) {
        this.engineId = engineId;
        this.pictures = pictures;
        this.sampling = sampling;
        this.part = part;
        this.linear = linear;
    }

    Engine engine() {
        if (engine.isEmpty()) {
            engine = Optional.of(Engines.open(engineId));
        }
        return engine.get();
    }

    /** What a file of the picture tells; the same for all of its parts, but for their samples. */
    Provenance provenance(FrameInput whole) {
        String software = "Twister " + TwisterVersion.text();
        String drawn = pictures.stream().map(Picture::id).collect(Collectors.joining(","));
        return new Provenance(
                software,
                digest.of(whole.withSamples(0, 1), software + " " + drawn),
                part.samples().orElse(sampling.text()));
    }

    /** Draws all that was asked for of a picture, or of the part that is wanted. */
    List<DrawnPicture> draw(FrameInput whole, PrintWriter err) {
        FrameInput input = part.of(whole);
        List<DrawnPicture> drawn = new ArrayList<>();
        for (Picture wanted : pictures) {
            boolean asRadiance = linear || !wanted.isColor();
            drawn.add(new DrawnPicture(
                    wanted, BandedDrawing.draw(engine(), input.showing(wanted), sampling, asRadiance, err)));
        }
        return drawn;
    }

    @Override
    public void close() {
        engine.ifPresent(Engine::close);
    }
}
