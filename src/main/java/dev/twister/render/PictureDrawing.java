package dev.twister.render;

import dev.twister.denoise.Denoiser;
import dev.twister.engine.Engine;
import dev.twister.files.TwisterVersion;
import dev.twister.image.Frame;
import dev.twister.image.Provenance;
import dev.twister.world.FrameDigest;
import dev.twister.world.FrameInput;
import dev.twister.world.Picture;
import dev.twister.world.TonedPixels;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** Renders the pictures of an order one after the other with the same engine. */
final class PictureDrawing implements AutoCloseable {
    private final RenderOrder order;
    private final FrameDigest digest = new FrameDigest();
    private Optional<Engine> engine = Optional.empty();
    private Optional<Denoiser> denoiser = Optional.empty();

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
                digest.of(
                        whole.withSamples(0, 1),
                        software + " " + drawn + order.finishing().text()),
                order.part().samplesText().orElse(order.sampling().text()));
    }

    /** Renders the order's pictures of a frame, or the part of them that it asks for. */
    List<DrawnAspect> draw(FrameInput whole, RenderProgress progress) {
        FrameInput input = order.part().of(whole);
        List<DrawnAspect> drawn = new ArrayList<>();
        for (Picture wanted : order.pictures()) {
            drawn.add(draw(wanted, input.showing(wanted), progress));
        }
        return drawn;
    }

    private DrawnAspect draw(Picture wanted, FrameInput input, RenderProgress progress) {
        if (order.output().background() == Background.NONE) {
            return new DrawnAspect(
                    wanted, Cutout.draw(engine(), input, order.sampling().samples(), progress), List.of());
        }
        boolean guided = order.finishing().guides(wanted);
        boolean asRadiance = order.output().isLinear() || !wanted.isColor() || guided;
        FrameInput shown = guided ? input.withGuides() : input;
        BandedDrawing.Drawn picture = BandedDrawing.draw(engine(), shown, order.sampling(), asRadiance, progress);
        return guided ? finished(wanted, shown, picture) : new DrawnAspect(wanted, picture, List.of());
    }

    private DrawnAspect finished(Picture wanted, FrameInput shown, BandedDrawing.Drawn drawn) {
        GuidedPicture guided = new GuidedPicture(drawn.frame());
        boolean denoises = order.finishing().denoiser().isPresent();
        Frame frame = denoises ? guided.denoised(denoiser()) : drawn.frame();
        Frame written = order.output().isLinear() ? frame : toned(frame, shown);
        return new DrawnAspect(wanted, drawn.with(written), guided.channels(denoises));
    }

    private static Frame toned(Frame linear, FrameInput input) {
        Frame pixels = Frame.ofPixels(linear.width(), linear.height());
        TonedPixels.write(linear.radiance(), input, pixels.argb());
        pixels.setTimes(linear.times());
        return pixels;
    }

    /** The denoiser, opened on the first call. */
    private Denoiser denoiser() {
        if (denoiser.isEmpty()) {
            denoiser = Optional.of(
                    order.finishing().denoiser().orElseThrow().opener().get());
        }
        return denoiser.get();
    }

    @Override
    public void close() {
        engine.ifPresent(Engine::close);
        denoiser.ifPresent(Denoiser::close);
    }
}
