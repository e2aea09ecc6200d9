package dev.twister.render;

import dev.twister.denoise.Denoiser;
import dev.twister.denoise.NoisyPicture;
import dev.twister.denoise.Plane;
import dev.twister.image.ExrChannel;
import dev.twister.image.Frame;
import dev.twister.kernel.Guides;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A picture that was rendered with guides of denoising.
 *
 * @param frame linear, with albedo, normal and the light of groups of lights as layers
 * @param lightGroups names of these groups
 */
record GuidedPicture(Frame frame, List<String> lightGroups) {
    private static final int ALBEDO = 0;
    private static final int NORMAL = 1;

    /** The frame without its noise, with the same times. */
    Frame denoised(Denoiser denoiser) {
        float[] radiance = denoiser.denoise(
                new NoisyPicture(frame.width(), frame.height(), new Plane(frame.radiance(), 0), Optional.of(guides())));
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
                    PictureLayers.light(lightGroups.get(group)), frame.layers(), frame.firstOf(Guides.LAYERS + group)));
        }
        if (noisy) {
            channels.addAll(PictureLayers.channels(PictureLayers.NOISY, frame.radiance(), 0));
        }
        return channels;
    }
}
