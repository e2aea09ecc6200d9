package dev.twister.render;

import dev.twister.denoise.Denoiser;
import dev.twister.denoise.NoisyPicture;
import dev.twister.denoise.Plane;
import dev.twister.engine.Engine;
import dev.twister.files.TwisterVersion;
import dev.twister.image.AlphaChannel;
import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.Frame;
import dev.twister.image.JoinedPicture;
import dev.twister.image.Provenance;
import dev.twister.kernel.Guides;
import dev.twister.world.FrameDigest;
import dev.twister.world.FrameInput;
import dev.twister.world.LightGroups;
import dev.twister.world.StageOrView;
import dev.twister.world.TonedPixels;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;

/** Renders the pictures of an order one after the other with the same engine. */
final class PictureDrawing implements AutoCloseable {
    private final RenderOrder order;
    private final Optional<LightGroups> lightGroups;
    private final DoubleFunction<FrameInput> moments;
    private final FrameDigest digest = new FrameDigest();
    private Optional<Engine> engine = Optional.empty();
    private Optional<Denoiser> denoiser = Optional.empty();

    /**
     * @param lightGroups of the scene; used if the order has light layers
     * @param moments the present frame at a part of the time in which the shutter is open, in [0, 1]
     */
    PictureDrawing(RenderOrder order, Supplier<LightGroups> lightGroups, DoubleFunction<FrameInput> moments) {
        this.order = order;
        this.moments = moments;
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
        String drawn = order.pictures().stream().map(StageOrView::id).collect(Collectors.joining(","))
                + (order.output().isCut() ? ", no background" : "");
        return new Provenance(
                software,
                digest.of(
                        whole.withSamples(0, 1),
                        software + " " + drawn + order.finishing().text() + shutterText()),
                order.part().samplesText().orElse(order.sampling().text()),
                order.pictures().getFirst().isColor() ? Optional.of(FileDisplay.of(whole)) : Optional.empty());
    }

    /** What moves while the shutter is open, by two moments before the frame's own; empty if nothing is blurred. */
    private String shutterText() {
        return order.movement().isBlurred()
                ? DoubleStream.of(0, 0.5)
                        .mapToObj(part -> digest.of(moments.apply(part).withSamples(0, 1), ""))
                        .collect(Collectors.joining(
                                " ", " shutter " + order.movement().shutter() + " ", ""))
                : "";
    }

    /** Renders the order's pictures of a frame, or the part of them that it asks for. */
    List<RenderedView> draw(FrameInput whole, RenderProgress progress) {
        FrameInput input = order.part().of(whole);
        List<RenderedView> drawn = new ArrayList<>();
        for (StageOrView wanted : order.pictures()) {
            drawn.add(draw(wanted, input, progress));
        }
        return drawn;
    }

    private RenderedView draw(StageOrView wanted, FrameInput input, RenderProgress progress) {
        boolean guided = order.finishing().guides(wanted);
        boolean cut = order.output().isCut() && Finishing.isFull(wanted);
        boolean asRadiance = order.output().isLinear() || !wanted.isColor() || guided || cut;
        FrameInput shown = showing(wanted, input);
        // The mean of the numbers of two bodies is the number of a third.
        BandedDrawing.Drawn picture = order.movement().isBlurred() && !wanted.isNumber()
                ? blurred(wanted, shown, asRadiance, progress)
                : BandedDrawing.draw(engine(), shown, order.sampling(), asRadiance, progress);
        List<ExrChannel> samples = samples(picture.samples());
        return guided || cut ? finished(wanted, shown, picture, samples) : new RenderedView(wanted, picture, samples);
    }

    private FrameInput showing(StageOrView wanted, FrameInput input) {
        FrameInput shown = input.showing(wanted);
        boolean guided = order.finishing().guides(wanted);
        FrameInput layered = guided ? lightGroups.map(shown::withLightLayers).orElseGet(shown::withGuides) : shown;
        return order.output().isCut() && Finishing.isFull(wanted) ? layered.withoutBackground() : layered;
    }

    private BandedDrawing.Drawn blurred(
            StageOrView wanted, FrameInput shown, boolean asRadiance, RenderProgress progress) {
        Sampling sampling = order.sampling();
        Engine shutter = new ShutterEngine(engine(), part -> showing(wanted, moments.apply(part)), samples -> {
            if (!sampling.isGradual()) {
                progress.part(engine().id(), (double) samples / sampling.samples(), Optional.empty());
            }
        });
        return BandedDrawing.drawAtOnce(shutter, shown, sampling, asRadiance, progress);
    }

    /** The number of samples of each pixel, if they differ and there is one picture alone. */
    private List<ExrChannel> samples(float[] samples) {
        return samples.length == 0 || order.pictures().size() > 1
                ? List.of()
                : List.of(new ExrChannel(JoinedPicture.SAMPLES, samples, 0, 1));
    }

    private RenderedView finished(
            StageOrView wanted, FrameInput shown, BandedDrawing.Drawn drawn, List<ExrChannel> samples) {
        GuidedPicture guided = new GuidedPicture(
                drawn.frame(), lightGroups.map(LightGroups::names).orElse(List.of()));
        Optional<AlphaChannel> alpha = shown.isCut() ? Optional.of(AlphaChannel.of(drawn.frame())) : Optional.empty();
        boolean denoises = order.finishing().denoiser().isPresent();
        Frame frame = denoises ? guided.denoised(denoiser()) : drawn.frame();
        if (denoises) {
            alpha.ifPresent(channel -> channel.cut(frame.radiance()));
        }
        Frame written = order.output().isLinear() ? frame : toned(frame, shown, alpha);
        List<ExrChannel> layers = new ArrayList<>(samples);
        alpha.ifPresent(channel -> layers.add(channel.channel()));
        if (order.finishing().guides(wanted)) {
            layers.addAll(guided.channels(denoises));
        }
        return new RenderedView(wanted, drawn.with(written), layers);
    }

    private static Frame toned(Frame linear, FrameInput input, Optional<AlphaChannel> alpha) {
        Frame pixels = Frame.ofPixels(linear.width(), linear.height());
        float[] colors =
                alpha.map(channel -> channel.straight(linear.radiance())).orElse(linear.radiance());
        TonedPixels.write(colors, input, pixels.argb());
        alpha.ifPresent(channel -> channel.put(pixels.argb()));
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

    /**
     * A picture that was rendered with guides of denoising.
     *
     * @param frame linear, with albedo, normal and the light of groups of lights as layers
     * @param lightGroups names of these groups
     */
    private record GuidedPicture(Frame frame, List<String> lightGroups) {
        private static final int ALBEDO = 0;
        private static final int NORMAL = 1;

        /** The frame without its noise, with the same times. */
        Frame denoised(Denoiser denoiser) {
            float[] radiance = denoiser.denoise(new NoisyPicture(
                    frame.width(), frame.height(), new Plane(frame.radiance(), 0), Optional.of(guides())));
            Frame denoised = Frame.ofRadiance(frame.width(), frame.height());
            System.arraycopy(radiance, 0, denoised.radiance(), 0, radiance.length);
            denoised.setTimes(frame.times());
            return denoised;
        }

        private NoisyPicture.Guides guides() {
            return new NoisyPicture.Guides(
                    new Plane(frame.layers(), frame.firstOf(ALBEDO)), new Plane(frame.layers(), frame.firstOf(NORMAL)));
        }

        /**
         * Channels of the guides, and of the groups of lights.
         *
         * @param noisy whether the noisy picture is a layer, too
         */
        List<ExrChannel> channels(boolean noisy) {
            List<ExrChannel> channels = new ArrayList<>();
            channels.addAll(PictureLayers.channels(PictureLayers.GUIDE_ALBEDO, frame.layers(), frame.firstOf(ALBEDO)));
            channels.addAll(PictureLayers.channels(PictureLayers.GUIDE_NORMAL, frame.layers(), frame.firstOf(NORMAL)));
            for (int group = 0; group < lightGroups.size(); group++) {
                channels.addAll(PictureLayers.channels(
                        PictureLayers.light(lightGroups.get(group)),
                        frame.layers(),
                        frame.firstOf(Guides.LAYERS + group)));
            }
            if (noisy) {
                channels.addAll(PictureLayers.channels(PictureLayers.NOISY, frame.radiance(), 0));
            }
            return channels;
        }
    }
}
