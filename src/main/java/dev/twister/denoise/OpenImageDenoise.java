package dev.twister.denoise;

import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Intel's Open Image Denoise, a neural network; in bands if the picture is large. The library runs in a process of its
 * own, which is started again for the next picture after it failed.
 */
final class OpenImageDenoise implements Denoiser {
    private static final int CHANNELS = 3;

    /** Limit of the time for a small picture, and of each further million pixels. */
    private static final long MOST_SECONDS = 120;

    private static final double SECONDS_A_MILLION_PIXELS = 60;

    private final String place;
    private final long mostSeconds;
    private final long mostPixels;
    private Optional<OidnProcess> process;

    /**
     * Opens a library.
     *
     * @param place its file, or a name for the system's loader
     * @throws DenoiseException if it does not work; the message continues its name
     */
    OpenImageDenoise(String place) {
        this(place, MOST_SECONDS, Bands.MOST_PIXELS);
    }

    /** As above, with another limit of the time for a small picture, and of the pixels of a band. */
    OpenImageDenoise(String place, long mostSeconds, long mostPixels) {
        this.place = place;
        this.mostSeconds = mostSeconds;
        this.mostPixels = mostPixels;
        process = Optional.of(new OidnProcess(place, mostSeconds));
    }

    /** Version and device, for display. */
    String text() {
        return process.map(OidnProcess::version).orElse("");
    }

    @Override
    public float[] denoise(NoisyPicture picture) {
        float[] denoised = new float[picture.values()];
        Bands bands = Bands.of(picture.width(), picture.height(), mostPixels);
        float scale = InputScale.of(picture);
        try {
            OidnProcess running = process.orElseGet(() -> new OidnProcess(place, mostSeconds));
            process = Optional.of(running);
            for (int band = 0; band < bands.count(); band++) {
                denoise(picture, bands, band, scale, running, denoised);
            }
        } catch (DenoiseException problem) {
            process = Optional.empty();
            throw new DenoiseException(place + " " + problem.getMessage(), problem);
        }
        return denoised;
    }

    private void denoise(
            NoisyPicture picture, Bands bands, int band, float scale, OidnProcess running, float[] denoised) {
        int top = bands.top(band);
        int rows = bands.bottom(band) - top;
        OidnServer.Request request = new OidnServer.Request(
                picture.width(),
                rows,
                bands.first(band) - top,
                bands.end(band) - top,
                picture.guides().isPresent(),
                scale);
        List<Plane> planes = new ArrayList<>(List.of(picture.radiance()));
        picture.guides().ifPresent(guides -> planes.addAll(List.of(guides.albedo(), guides.normal())));
        int stride = CHANNELS * picture.width();
        int first = stride * bands.first(band);
        double millions = (double) picture.width() * rows / 1e6;
        running.denoise(
                request,
                planes.stream()
                        .map(plane -> FloatBuffer.wrap(plane.values(), plane.first() + stride * top, stride * rows))
                        .toList(),
                FloatBuffer.wrap(denoised, first, stride * bands.end(band) - first),
                mostSeconds + (long) (SECONDS_A_MILLION_PIXELS * Math.floor(millions)));
    }

    @Override
    public void close() {
        process.ifPresent(OidnProcess::close);
        process = Optional.empty();
    }
}
