package dev.twister.gui.viewer;

import dev.twister.denoise.Denoiser;
import dev.twister.denoise.DenoiserOffer;
import dev.twister.denoise.Denoisers;
import dev.twister.denoise.NoisyPicture;
import dev.twister.denoise.NoisyPicture.Guides;
import dev.twister.denoise.Plane;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrReader;
import dev.twister.image.ExrReader.ExrExtent;
import dev.twister.image.Provenance;
import dev.twister.render.DenoisedPicture;
import dev.twister.render.FileDisplay;
import dev.twister.render.PictureFormat;
import dev.twister.render.PictureLayers;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A picture of a file.
 *
 * @param radiance linear, three floats per pixel
 * @param display the exposure, tone map and transfer function of the file
 * @param lights its light layers; none if the file has none
 * @param guides of denoising, if the file has them
 * @param clean the radiance without noise, if the file has it
 * @param part which part of the file it is, if there are several
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record ViewedPicture(
        int width,
        int height,
        float[] radiance,
        Rendering display,
        List<Light> lights,
        Optional<Guides> guides,
        Optional<float[]> clean,
        Optional<String> part) {
    private static final int CHANNELS = 3;
    private static final Rgb UNCHANGED = new Rgb(1, 1, 1);

    /**
     * The light of a group of lights.
     *
     * @param radiance as that of the picture
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    public record Light(String group, float[] radiance) {}

    /**
     * Reads a PNG, Radiance or OpenEXR file.
     *
     * @throws IOException if it cannot be read, or has no colors
     * @throws dev.twister.scene.SceneException as above
     */
    public static ViewedPicture read(Path file) throws IOException {
        if (!PictureFormat.of(file).equals(Optional.of(PictureFormat.EXR))) {
            Skybox image = SkyboxReader.read(file);
            return new ViewedPicture(
                    image.width(),
                    image.height(),
                    image.radiance(),
                    FileDisplay.settings(
                            PictureFormat.of(file).equals(Optional.of(PictureFormat.HDR))
                                    ? Provenance.ofFile(file, 0, image.height())
                                    : Optional.empty()),
                    List.of(),
                    Optional.empty(),
                    Optional.empty(),
                    Optional.empty());
        }
        ExrExtent extent = ExrReader.extent(file);
        if (extent.rows() < extent.height()) {
            throw new IOException(file + " is a part of a picture; 'twister join' makes a picture of parts");
        }
        ExrPicture picture = ExrReader.read(file);
        float[] colors = PictureLayers.of(picture, PictureLayers.COLORS)
                .orElseThrow(() -> new IOException(file + " has no colors, only numbers"));
        List<Light> lights = new ArrayList<>();
        for (String group : PictureLayers.lightGroups(picture)) {
            PictureLayers.of(picture, PictureLayers.light(group))
                    .ifPresent(radiance -> lights.add(new Light(group, radiance)));
        }
        Optional<float[]> noisy = PictureLayers.of(picture, PictureLayers.NOISY);
        return new ViewedPicture(
                picture.width(),
                picture.height(),
                noisy.orElse(colors),
                FileDisplay.settings(picture.provenance()),
                List.copyOf(lights),
                DenoisedPicture.guides(picture),
                noisy.map(_ -> colors),
                ExrReader.part(file));
    }

    /**
     * The radiance with other strengths and colors of the lights; the file's own if all are unchanged.
     *
     * @param factors of each of the lights, per channel
     */
    public float[] lit(List<Rgb> factors) {
        if (isUnchanged(factors)) {
            return radiance;
        }
        float[] sum = new float[radiance.length];
        for (int index = 0; index < lights.size(); index++) {
            Rgb factor = factors.get(index);
            float[] channels = {(float) factor.red(), (float) factor.green(), (float) factor.blue()};
            float[] light = lights.get(index).radiance();
            for (int i = 0; i < sum.length; i++) {
                sum[i] += channels[i % CHANNELS] * light[i];
            }
        }
        return sum;
    }

    private static boolean isUnchanged(List<Rgb> factors) {
        return factors.stream().allMatch(UNCHANGED::equals);
    }

    /** {@link #lit} without noise, if the file has it. */
    public Optional<float[]> clean(List<Rgb> factors) {
        return clean.filter(_ -> isUnchanged(factors));
    }

    /** The picture {@link #lit} with its guides. */
    public NoisyPicture noisy(List<Rgb> factors) {
        return new NoisyPicture(width, height, new Plane(lit(factors), 0), guides);
    }

    /** A pixel's red, green or blue in {@link #lit}. */
    public int at(int column, int row, int channel) {
        return CHANNELS * (row * width + column) + channel;
    }

    /** Removes the noise of a file's picture with other strengths and colors of its lights. Keeps the newest result. */
    public static final class Denoising {
        private final ViewedPicture picture;
        private Optional<DenoiserOffer> offer = Optional.empty();
        private volatile Optional<Clean> newest = Optional.empty();

        @SuppressWarnings("ArrayRecordComponent") // never compared
        private record Clean(List<Rgb> factors, float[] radiance) {}

        public Denoising(ViewedPicture picture) {
            this.picture = picture;
        }

        /** The radiance without noise, if it is known for these factors of the lights. */
        public Optional<float[]> known(List<Rgb> factors) {
            return picture.clean(factors)
                    .or(() -> newest.filter(clean -> clean.factors().equals(factors))
                            .map(Clean::radiance));
        }

        /** Whether {@link #clean} has something to do. */
        public boolean isDue(List<Rgb> factors) {
            return picture.guides().isPresent() && known(factors).isEmpty();
        }

        /**
         * Removes the noise; may take seconds. Used by one thread at a time.
         *
         * @throws dev.twister.denoise.DenoiseException if there is no denoiser, or it fails
         */
        public float[] clean(List<Rgb> factors) {
            DenoiserOffer found = offer.orElseGet(Denoisers::offer);
            offer = Optional.of(found);
            NoisyPicture noisy = picture.noisy(factors);
            try (Denoiser denoiser = found.opener().get()) {
                float[] radiance = denoiser.denoise(noisy);
                newest = Optional.of(new Clean(factors, radiance));
                return radiance;
            }
        }
    }
}
