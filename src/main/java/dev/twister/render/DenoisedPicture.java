package dev.twister.render;

import dev.twister.denoise.Denoiser;
import dev.twister.denoise.NoisyPicture;
import dev.twister.denoise.NoisyPicture.Guides;
import dev.twister.denoise.Plane;
import dev.twister.image.AlphaChannel;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrPicture.ExrChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A picture of an .exr file without its noise. The noisy one is kept as a layer, and is the one that is denoised if the
 * file has it already.
 *
 * @param picture with the denoised colors, and all other layers
 * @param guided whether the file has guides, or else views of albedo and normal
 * @param notFinite number of values that were not finite, and counted as 0
 * @param kept number of values that the denoiser made not finite, and that stay as they were
 */
public record DenoisedPicture(ExrPicture picture, boolean guided, long notFinite, long kept) {
    /** Memory for denoising, in bytes per pixel, without the picture that was read. */
    public static final long BYTES_PER_PIXEL = 12L * Float.BYTES;

    /**
     * Removes the noise.
     *
     * @param picture whole
     * @throws IllegalArgumentException if the picture has no colors; the message continues the file's name
     * @throws dev.twister.denoise.DenoiseException if the denoiser fails
     */
    public static DenoisedPicture of(ExrPicture picture, Denoiser denoiser) {
        float[] noisy = PictureLayers.of(picture, PictureLayers.NOISY)
                .or(() -> PictureLayers.of(picture, PictureLayers.COLORS))
                .orElseThrow(() -> new IllegalArgumentException("has no colors, only numbers"));
        Optional<Guides> guides = guides(picture);
        float[] denoised =
                denoiser.denoise(new NoisyPicture(picture.width(), picture.height(), new Plane(noisy, 0), guides));
        long kept = notFinite(denoised);
        for (int i = 0; kept > 0 && i < denoised.length; i++) {
            if (!Float.isFinite(denoised[i])) {
                denoised[i] = Float.isFinite(noisy[i]) ? noisy[i] : 0;
            }
        }
        AlphaChannel.of(picture).ifPresent(alpha -> alpha.cut(denoised));
        List<ExrChannel> channels = new ArrayList<>(picture.channels());
        channels.removeIf(channel ->
                PictureLayers.COLORS.contains(channel.name()) || PictureLayers.NOISY.contains(channel.name()));
        channels.addAll(PictureLayers.channels(PictureLayers.COLORS, denoised, 0));
        channels.addAll(PictureLayers.channels(PictureLayers.NOISY, noisy, 0));
        long notFinite = Stream.concat(
                        Stream.of(noisy),
                        guides.stream()
                                .flatMap(guide -> Stream.of(
                                        guide.albedo().values(), guide.normal().values())))
                .mapToLong(DenoisedPicture::notFinite)
                .sum();
        return new DenoisedPicture(
                new ExrPicture(
                        picture.width(),
                        picture.height(),
                        picture.firstRow(),
                        picture.rows(),
                        channels,
                        picture.provenance()),
                guides.isPresent(),
                notFinite,
                kept);
    }

    /** The guides of denoising, or the views of the first surfaces. */
    public static Optional<Guides> guides(ExrPicture picture) {
        return guides(
                        PictureLayers.of(picture, PictureLayers.GUIDE_ALBEDO),
                        PictureLayers.of(picture, PictureLayers.GUIDE_NORMAL))
                .or(() -> guides(
                        PictureLayers.of(picture, PictureLayers.layer("albedo", "RGB")),
                        PictureLayers.of(picture, PictureLayers.layer("normal", "RGB"))
                                .map(DenoisedPicture::asDirections)));
    }

    private static Optional<Guides> guides(Optional<float[]> albedo, Optional<float[]> normal) {
        return albedo.flatMap(
                colors -> normal.map(directions -> new Guides(new Plane(colors, 0), new Plane(directions, 0))));
    }

    /** Views show normals as colors. */
    private static float[] asDirections(float[] colors) {
        float[] directions = new float[colors.length];
        for (int i = 0; i < colors.length; i++) {
            directions[i] = 2 * colors[i] - 1;
        }
        return directions;
    }

    private static long notFinite(float[] values) {
        long count = 0;
        for (float value : values) {
            count += Float.isFinite(value) ? 0 : 1;
        }
        return count;
    }
}
