package dev.twister.render;

import dev.twister.denoise.Denoiser;
import dev.twister.engine.Engine;
import dev.twister.files.TwisterVersion;
import dev.twister.image.ExrChannel;
import dev.twister.image.Frame;
import dev.twister.image.JoinedPicture;
import dev.twister.image.Provenance;
import dev.twister.world.FrameDigest;
import dev.twister.world.FrameInput;
import dev.twister.world.LightGroups;
import dev.twister.world.Picture;
import dev.twister.world.TonedPixels;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/** Renders the pictures of an order one after the other with the same engine. */
final class PictureDrawing implements AutoCloseable {
    private final RenderOrder order;
    private final Optional<LightGroups> lightGroups;
    private final FrameDigest digest = new FrameDigest();
    private Optional<Engine> engine = Optional.empty();
    private Optional<Denoiser> denoiser = Optional.empty();

    /** @param lightGroups of the scene; used if the order has light layers */
    PictureDrawing(RenderOrder order, Supplier<LightGroups> lightGroups) {
        this.order = order;
        this.lightGroups = order.finishing().lightLayers() ? Optional.of(lightGroups.get()) : Optional.empty();
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
                order.part().samplesText().orElse(order.sampling().text()),
                order.pictures().getFirst().isColor() ? Optional.of(FileDisplay.of(whole)) : Optional.empty());
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
        FrameInput shown = guided ? lightGroups.map(input::withLightLayers).orElseGet(input::withGuides) : input;
        BandedDrawing.Drawn picture = BandedDrawing.draw(engine(), shown, order.sampling(), asRadiance, progress);
        List<ExrChannel> samples = samples(picture.samples());
        return guided ? finished(wanted, shown, picture, samples) : new DrawnAspect(wanted, picture, samples);
    }

    /** The number of samples of each pixel, if they differ and there is one picture alone. */
    private List<ExrChannel> samples(float[] samples) {
        return samples.length == 0 || order.pictures().size() > 1
                ? List.of()
                : List.of(new ExrChannel(JoinedPicture.SAMPLES, samples, 0, 1));
    }

    private DrawnAspect finished(
            Picture wanted, FrameInput shown, BandedDrawing.Drawn drawn, List<ExrChannel> samples) {
        GuidedPicture guided = new GuidedPicture(
                drawn.frame(), lightGroups.map(LightGroups::names).orElse(List.of()));
        boolean denoises = order.finishing().denoiser().isPresent();
        Frame frame = denoises ? guided.denoised(denoiser()) : drawn.frame();
        Frame written = order.output().isLinear() ? frame : toned(frame, shown);
        List<ExrChannel> layers = new ArrayList<>(guided.channels(denoises));
        layers.addAll(samples);
        return new DrawnAspect(wanted, drawn.with(written), layers);
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
