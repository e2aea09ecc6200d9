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
import java.util.stream.Collectors;

/** Renders the pictures of an order one after the other with the same engine. */
final class PictureDrawing implements AutoCloseable {
    private final RenderOrder order;
    private final FrameDigest digest = new FrameDigest();
    private Optional<Engine> engine = Optional.empty();

    PictureDrawing(RenderOrder order) {
        this.order = order;
    }

    /** The engine, opened on the first call. */
    Engine engine() {
        if (engine.isEmpty()) {
            engine = Optional.of(order.engine().opener().get());
        }
        return engine.get();
    }

    /** How the file of a picture is made; equal for all of its parts, except their samples. */
    Provenance provenance(FrameInput whole) {
        String software = "Twister " + TwisterVersion.text();
        String drawn = order.pictures().stream().map(Picture::id).collect(Collectors.joining(","))
                + (order.output().background() == Background.NONE ? ", no background" : "");
        return new Provenance(
                software,
                digest.of(whole.withSamples(0, 1), software + " " + drawn),
                order.part().samplesText().orElse(order.sampling().text()));
    }

    /** Renders the order's pictures of a frame, or the part of them that it asks for. */
    List<DrawnAspect> draw(FrameInput whole, RenderProgress progress) {
        FrameInput input = order.part().of(whole);
        List<DrawnAspect> drawn = new ArrayList<>();
        for (Picture wanted : order.pictures()) {
            drawn.add(new DrawnAspect(wanted, draw(wanted, input.showing(wanted), progress)));
        }
        return drawn;
    }

    private BandedDrawing.Drawn draw(Picture wanted, FrameInput input, RenderProgress progress) {
        if (order.output().background() == Background.NONE) {
            return Cutout.draw(engine(), input, order.sampling().samples(), progress);
        }
        boolean asRadiance = order.output().isLinear() || !wanted.isColor();
        return BandedDrawing.draw(engine(), input, order.sampling(), asRadiance, progress);
    }

    @Override
    public void close() {
        engine.ifPresent(Engine::close);
    }
}
