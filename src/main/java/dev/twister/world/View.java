package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Views;
import java.util.Arrays;

/**
 * Camera and settings of a picture as the kernel reads them.
 *
 * @param frame the array {@code frame} of {@link Layout}, which is immutable
 * @param stageOrView what to render: a constant of {@link Views}
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see FrameInput
public record View(float[] frame, int stageOrView) {
    /**
     * A view of the values from {@link Layout#CAMERA_POSITION} to {@link Layout#MAPS} with tables behind them.
     *
     * @param disc points of the unit sunflower, {@code sqrt(i / n)} from the center: x and y of each shadow sample
     * @param samples {@link PixelSamples}
     */
    public static View of(float[] values, float[] disc, float[] samples, int stageOrView) {
        float[] frame = new float[Layout.DISC + disc.length + samples.length];
        System.arraycopy(values, 0, frame, 0, Layout.SAMPLES);
        frame[Layout.TILES] = 0;
        frame[Layout.SAMPLES] = Layout.DISC + disc.length;
        System.arraycopy(disc, 0, frame, Layout.DISC, disc.length);
        System.arraycopy(samples, 0, frame, Layout.DISC + disc.length, samples.length);
        return new View(frame, stageOrView);
    }

    /**
     * A number of one of the pixel's samples.
     *
     * @param place in [0, {@link Layout#SAMPLE_STRIDE}): 0 and 1 for its position in the pixel, x and y
     */
    public float sample(int sample, int place) {
        return frame[samplePlace(sample) + place];
    }

    /** Place of one of the pixel's samples in the frame. */
    public int samplePlace(int sample) {
        return samplesStart() + Layout.SAMPLE_STRIDE * sample;
    }

    private int samplesStart() {
        return (int) frame[Layout.SAMPLES];
    }

    public View withSize(int width, int height) {
        float[] sized = frame.clone();
        sized[Layout.WIDTH] = width;
        sized[Layout.HEIGHT] = height;
        return new View(sized, stageOrView).withRows(0, height);
    }

    View withRows(int firstRow, int rows) {
        float[] banded = frame.clone();
        banded[Layout.FIRST_ROW] = firstRow;
        banded[Layout.ROWS] = rows;
        return new View(banded, stageOrView);
    }

    View withSamples(int first, int samples) {
        float[] counted = Arrays.copyOf(frame, Layout.DISC);
        counted[Layout.PIXEL_SAMPLES] = samples;
        counted[Layout.FIRST_SAMPLE] = first;
        return of(counted, disc(), PixelSamples.of(first, samples), stageOrView);
    }

    /** The tiles are behind all else; the tables before them keep their places. */
    View withTiles(boolean[] wanted) {
        int end = samplePlace((int) frame[Layout.PIXEL_SAMPLES]);
        float[] limited = Arrays.copyOf(frame, end + wanted.length);
        limited[Layout.TILES] = end;
        for (int tile = 0; tile < wanted.length; tile++) {
            limited[end + tile] = wanted[tile] ? 1 : 0;
        }
        return new View(limited, stageOrView);
    }

    View showing(StageOrView picture) {
        float[] shown = frame.clone();
        if (!picture.bounces()) {
            shown[Layout.BOUNCES] = 0;
        }
        boolean hard = picture == StageOrView.HARD_SHADOWS;
        if (hard) {
            shown[Layout.SHADOW_SAMPLES] = 1;
        }
        return of(shown, hard ? SunflowerDisc.points(1) : disc(), samples(), picture.stageOrView());
    }

    private float[] disc() {
        return Arrays.copyOfRange(frame, Layout.DISC, samplesStart());
    }

    private float[] samples() {
        return Arrays.copyOfRange(frame, samplesStart(), samplePlace((int) frame[Layout.PIXEL_SAMPLES]));
    }
}
