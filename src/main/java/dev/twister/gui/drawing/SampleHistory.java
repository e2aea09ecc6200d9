package dev.twister.gui.drawing;

import dev.twister.denoise.GuidedFilter;
import dev.twister.denoise.NoisyPicture;
import dev.twister.denoise.Plane;
import dev.twister.gui.picking.Projection;
import dev.twister.kernel.CameraRay;
import dev.twister.kernel.Layout;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The samples of a picture and of those before it, which were drawn from where the camera was then: what a pixel shows
 * is looked up in the picture before, if it was seen there (Schied et al. 2017, "Spatiotemporal Variance-Guided
 * Filtering", section 4.1). Light is taken over without the color of the surface that it falls on. Never changes.
 */
final class SampleHistory {
    private static final int CHANNELS = 3;

    /** Of earlier pictures: with more, mirrors and glass would show for long what they no longer show. */
    private static final float MOST_SAMPLES = 16;

    /** Difference of the distances to a point, relative to the distance, from which on it is another point. */
    private static final double OTHER_DISTANCE = 0.05;

    /** Squared differences of normals and of albedos from which on a surface is another one. */
    private static final float OTHER_NORMAL = 0.1f;

    private static final float OTHER_ALBEDO = 0.05f;

    /** The least weight of the pixels around a place that are worth a value; that of all is 1. */
    private static final float LEAST_WEIGHT = 0.1f;

    /** Meters to the sky. */
    private static final double FAR = 1e6;

    private final View view;
    private final Projection projection;
    private final float[] radiance;
    private final float[] albedo;
    private final float[] normal;

    /** Of the noise of the radiance. */
    private final float[] difference;

    /** Per pixel, those of earlier pictures too. */
    private final float[] samples;

    private final int newSamples;
    private final int nextSample;

    /**
     * What a camera sees.
     *
     * @param input of the picture
     * @param distances in meters to the first hit of each pixel's view ray; 0 for the sky
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    record View(FrameInput input, float[] distances) {
        /** The point of the scene in the middle of a pixel. */
        private Vector3 point(int x, int y, float[] path) {
            CameraRay.start(path, x + 0.5f, y + 0.5f, input.view().frame());
            float distance = distances[y * input.width() + x];
            double meters = distance > 0 ? distance : FAR;
            Vector3 origin = input.bodies().origin();
            return new Vector3(
                    origin.x() + path[Layout.ORIGIN] + meters * path[Layout.DIRECTION],
                    origin.y() + path[Layout.ORIGIN + 1] + meters * path[Layout.DIRECTION + 1],
                    origin.z() + path[Layout.ORIGIN + 2] + meters * path[Layout.DIRECTION + 2]);
        }
    }

    /**
     * The samples of a picture, and those of earlier ones.
     *
     * @param picture with guides
     * @param newSamples per pixel of the picture
     */
    SampleHistory(View view, NoisyPicture picture, int newSamples, Optional<SampleHistory> earlier) {
        this.view = view;
        this.newSamples = newSamples;
        projection = Projection.of(view.input());
        NoisyPicture.Guides guides = picture.guides().orElseThrow();
        radiance = copy(picture.radiance());
        albedo = copy(guides.albedo());
        normal = copy(guides.normal());
        difference = picture.noise().map(noise -> copy(noise.difference())).orElseGet(this::differencesOfNeighbors);
        samples = new float[view.distances().length];
        Arrays.fill(samples, newSamples);
        nextSample = newSamples + earlier.map(SampleHistory::nextSample).orElse(0);
        earlier.ifPresent(this::add);
    }

    private float[] copy(Plane plane) {
        return Arrays.copyOfRange(plane.values(), plane.first(), plane.first() + CHANNELS * view.distances().length);
    }

    /** As if the light of pixels side by side were the same. */
    private float[] differencesOfNeighbors() {
        float[] differences = new float[radiance.length];
        float scale = (float) Math.sqrt(0.5);
        for (int i = CHANNELS; i < radiance.length; i++) {
            differences[i] = scale * (radiance[i] - radiance[i - CHANNELS]);
        }
        return differences;
    }

    float[] images() {
        return view.input().images();
    }

    /** The number of the first sample that is in no picture yet. */
    int nextSample() {
        return nextSample;
    }

    /** The mean of all samples. */
    NoisyPicture noisy() {
        return new NoisyPicture(
                view.input().width(),
                view.input().height(),
                new Plane(radiance, 0),
                Optional.of(new NoisyPicture.Guides(new Plane(albedo, 0), new Plane(normal, 0))),
                Optional.of(new NoisyPicture.Noise(new Plane(difference, 0), newSamples)));
    }

    private void add(SampleHistory earlier) {
        int width = view.input().width();
        IntStream.range(0, view.input().height()).parallel().forEach(y -> {
            float[] path = new float[Layout.PATH_LENGTH];
            Found found = new Found();
            for (int x = 0; x < width; x++) {
                int pixel = y * width + x;
                if (earlier.find(view.point(x, y, path), this, pixel, found)) {
                    add(found, pixel);
                }
            }
        });
    }

    private void add(Found found, int pixel) {
        float old = Math.min(MOST_SAMPLES, found.samples);
        float share = old / (old + newSamples);
        // The variance of a weighted mean's parts from their difference.
        float spread = (float) Math.sqrt(share * (1 - share));
        for (int channel = 0; channel < CHANNELS; channel++) {
            int at = CHANNELS * pixel + channel;
            albedo[at] += share * (found.albedo[channel] - albedo[at]);
            normal[at] += share * (found.normal[channel] - normal[at]);
            float earlier = found.light[channel] * GuidedFilter.tint(albedo[at]);
            difference[at] = spread * (radiance[at] - earlier);
            radiance[at] += share * (earlier - radiance[at]);
        }
        samples[pixel] = old + newSamples;
    }

    /** What was seen around a place. */
    private static final class Found {
        private final float[] light = new float[CHANNELS];
        private final float[] albedo = new float[CHANNELS];
        private final float[] normal = new float[CHANNELS];
        private float samples;
        private float weight;

        private void clear() {
            Arrays.fill(light, 0);
            Arrays.fill(albedo, 0);
            Arrays.fill(normal, 0);
            samples = 0;
            weight = 0;
        }

        private void divide() {
            for (int channel = 0; channel < CHANNELS; channel++) {
                light[channel] /= weight;
                albedo[channel] /= weight;
                normal[channel] /= weight;
            }
            samples /= weight;
        }
    }

    /** Looks up what was seen of a point that a pixel of another picture shows; returns whether it was. */
    private boolean find(Vector3 point, SampleHistory other, int otherPixel, Found found) {
        double[] place = projection.point(point);
        if (place.length == 0) {
            return false;
        }
        double distance = other.view.distances()[otherPixel] > 0 ? projection.distance(point) : 0;
        int left = (int) Math.floor(place[0] - 0.5);
        int top = (int) Math.floor(place[1] - 0.5);
        found.clear();
        for (int y = Math.max(0, top); y <= Math.min(view.input().height() - 1, top + 1); y++) {
            for (int x = Math.max(0, left); x <= Math.min(view.input().width() - 1, left + 1); x++) {
                int pixel = y * view.input().width() + x;
                double away = Math.abs(view.distances()[pixel] - distance);
                if (away <= OTHER_DISTANCE * distance && showsTheSurfaceOf(pixel, other, otherPixel)) {
                    double weight = (1 - Math.abs(place[0] - 0.5 - x)) * (1 - Math.abs(place[1] - 0.5 - y));
                    add(pixel, (float) weight, found);
                }
            }
        }
        if (found.weight < LEAST_WEIGHT) {
            return false;
        }
        found.divide();
        return true;
    }

    private boolean showsTheSurfaceOf(int pixel, SampleHistory other, int otherPixel) {
        return squared(normal, pixel, other.normal, otherPixel) < OTHER_NORMAL
                && squared(albedo, pixel, other.albedo, otherPixel) < OTHER_ALBEDO;
    }

    private static float squared(float[] values, int pixel, float[] others, int otherPixel) {
        float sum = 0;
        for (int channel = 0; channel < CHANNELS; channel++) {
            float difference = values[CHANNELS * pixel + channel] - others[CHANNELS * otherPixel + channel];
            sum += difference * difference;
        }
        return sum;
    }

    private void add(int pixel, float weight, Found found) {
        for (int channel = 0; channel < CHANNELS; channel++) {
            int at = CHANNELS * pixel + channel;
            found.light[channel] += weight * radiance[at] / GuidedFilter.tint(albedo[at]);
            found.albedo[channel] += weight * albedo[at];
            found.normal[channel] += weight * normal[at];
        }
        found.samples += weight * samples[pixel];
        found.weight += weight;
    }
}
