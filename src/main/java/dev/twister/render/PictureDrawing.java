package dev.twister.render;

import dev.twister.engine.Engine;
import dev.twister.files.TwisterVersion;
import dev.twister.image.Provenance;
import dev.twister.world.FrameDigest;
import dev.twister.world.FrameInput;
import dev.twister.world.Picture;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/** Draws pictures one after the other, all with the same engine, which is opened with the first one. */
public final class PictureDrawing implements AutoCloseable {
    private final Supplier<Engine> opener;
    private final List<Picture> pictures;
    private final Sampling sampling;
    private final PicturePart part;
    private final boolean linear;
    private final FrameDigest digest = new FrameDigest();
    private Optional<Engine> engine = Optional.empty();

    /**
     * Draws nothing yet.
     *
     * @param opener opens the engine, which {@link #close} closes
     * @param pictures what is drawn of each
     * @param linear whether colors are wanted as radiance
     */
    public PictureDrawing(
            Supplier<Engine> opener, List<Picture> pictures, Sampling sampling, PicturePart part, boolean linear) {
        this.opener = opener;
        this.pictures = pictures;
        this.sampling = sampling;
        this.part = part;
        this.linear = linear;
    }

    /** What draws. */
    public Engine engine() {
        if (engine.isEmpty()) {
            engine = Optional.of(opener.get());
        }
        return engine.get();
    }

    /** What is drawn of each. */
    PicturePart part() {
        return part;
    }

    /** What a file of the picture tells; the same for all of its parts, but for their samples. */
    public Provenance provenance(FrameInput whole) {
        String software = "Twister " + TwisterVersion.text();
        String drawn = pictures.stream().map(Picture::id).collect(Collectors.joining(","));
        return new Provenance(
                software,
                digest.of(whole.withSamples(0, 1), software + " " + drawn),
                part.samplesText().orElse(sampling.text()));
    }

    /** Draws all that was asked for of a picture, or of the part that is wanted. */
    public List<DrawnPicture> draw(FrameInput whole, RenderProgress progress) {
        FrameInput input = part.of(whole);
        List<DrawnPicture> drawn = new ArrayList<>();
        for (Picture wanted : pictures) {
            boolean asRadiance = linear || !wanted.isColor();
            drawn.add(new DrawnPicture(
                    wanted, BandedDrawing.draw(engine(), input.showing(wanted), sampling, asRadiance, progress)));
        }
        return drawn;
    }

    @Override
    public void close() {
        engine.ifPresent(Engine::close);
    }
}
