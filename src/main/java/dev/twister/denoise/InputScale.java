package dev.twister.denoise;

import java.util.stream.IntStream;

/**
 * The factor that brings a picture to the brightness which the denoiser was trained with: the one that Open Image
 * Denoise would choose for the whole picture, so that bands of it are denoised alike.
 */
final class InputScale {
    private static final int BLOCK = 16;
    private static final double KEY = 0.18;
    private static final double LEAST = 1e-8;
    private static final int CHANNELS = 3;

    private InputScale() {}

    /** The factor; 1 for a black picture. */
    static float of(NoisyPicture picture) {
        int rows = Math.ceilDiv(picture.height(), BLOCK);
        int columns = Math.ceilDiv(picture.width(), BLOCK);
        double[] logarithms = IntStream.range(0, rows * columns)
                .parallel()
                .mapToDouble(block -> luminance(picture, block % columns * BLOCK, block / columns * BLOCK))
                .filter(luminance -> luminance > LEAST)
                .map(luminance -> Math.log(luminance))
                .toArray();
        double sum = 0;
        for (double logarithm : logarithms) {
            sum += logarithm;
        }
        return logarithms.length == 0 ? 1f : (float) (KEY / Math.exp(sum / logarithms.length));
    }

    private static double luminance(NoisyPicture picture, int left, int top) {
        int right = Math.min(left + BLOCK, picture.width());
        int bottom = Math.min(top + BLOCK, picture.height());
        double sum = 0;
        for (int row = top; row < bottom; row++) {
            int at = picture.radiance().first() + CHANNELS * (row * picture.width() + left);
            for (int column = left; column < right; column++) {
                sum += luminance(picture.radiance().values(), at);
                at += CHANNELS;
            }
        }
        return sum / ((right - left) * (bottom - top));
    }

    private static double luminance(float[] values, int at) {
        double luminance = 0.212671 * values[at] + 0.715160 * values[at + 1] + 0.072169 * values[at + 2];
        return Double.isFinite(luminance) ? Math.max(luminance, 0) : 0;
    }
}
