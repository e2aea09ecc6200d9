package dev.twister.world.table;

import dev.twister.kernel.Layout;
import java.util.HashMap;
import java.util.Map;

/** The mean luminance that bodies emit, with their emission maps. */
final class EmissionMeans {
    private final float[] looks;
    private final int maps;
    private final float[] images;
    private final Map<Integer, double[]> meanByStart = new HashMap<>();

    /**
     * @param looks with the emission of lights, too
     * @param maps place of the maps' table in the looks
     */
    EmissionMeans(float[] looks, int maps, float[] images) {
        this.looks = looks;
        this.maps = maps;
        this.images = images;
    }

    /** The mean over a body's surface; 0 if it emits nothing. */
    double of(int body) {
        int emission = Layout.LOOK_STRIDE * body + Layout.LOOK_EMISSION;
        double whole = SkyProbabilities.luminance(looks, emission);
        int number = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_MAPS];
        int map = maps + Layout.MAPS_STRIDE * (number - 1) + Layout.MAPS_EMISSION;
        if (whole == 0 || number == 0 || looks[map + Layout.MAP_WIDTH] == 0) {
            return whole;
        }
        double[] mean = meanByStart.computeIfAbsent((int) looks[map + Layout.MAP_START], _ -> mean(map));
        float[] mapped = new float[mean.length];
        for (int channel = 0; channel < mapped.length; channel++) {
            mapped[channel] = (float) (looks[emission + channel] * mean[channel]);
        }
        return SkyProbabilities.luminance(mapped, 0);
    }

    private double[] mean(int map) {
        int start = Layout.ALIGNMENT * (int) looks[map + Layout.MAP_START];
        int width = (int) looks[map + Layout.MAP_WIDTH];
        int height = (int) looks[map + Layout.MAP_HEIGHT];
        int count = width * height;
        double[] mean = new double[Layout.TEXEL_STRIDE];
        boolean packed = (int) looks[map + Layout.MAP_SAMPLER] / Layout.SAMPLER_PACKED % 2 == 1;
        for (int i = 0; i < Layout.TEXEL_STRIDE * count; i++) {
            int channel = i % Layout.TEXEL_STRIDE;
            mean[channel] += images[packed ? code(start, i) : start + i] / (double) count;
        }
        return mean;
    }

    /** The place of what a packed texel's code stands for. */
    private int code(int start, int i) {
        int texel = (int) images[start + i / Layout.TEXEL_STRIDE];
        return start - Layout.CODES + ((texel >> (8 * (i % Layout.TEXEL_STRIDE))) & 255);
    }
}
