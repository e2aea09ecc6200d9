package dev.twister.gui.viewer;

import dev.twister.scene.Rendering;
import dev.twister.world.TonedPixels;

/**
 * Two pictures of the same size, to be looked at together.
 *
 * @param first radiance, linear, three floats per pixel
 * @param second as the first
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record ComparedPictures(int width, int height, float[] first, float[] second) {
    /** How they are shown. */
    public enum Mode {
        FIRST("Picture", "The picture of the file alone."),
        SECOND("Rendering", "The rendering alone. F goes to and fro between the two."),
        SIDE_BY_SIDE("Side by side", "The picture at the left, the rendering at the right."),
        WIPE("Wipe", "The picture at the left of a line, the rendering at the right; the pointer moves the line."),
        DIFFERENCE("Difference", "How far the two are apart, per channel, with the exposure.");

        private final String label;
        private final String hint;

        Mode(String label, String hint) {
            this.label = label;
            this.hint = hint;
        }

        public String label() {
            return label;
        }

        public String hint() {
            return hint;
        }
    }

    /** How wide the two are together. */
    public int width(Mode mode) {
        return mode == Mode.SIDE_BY_SIDE ? 2 * width : width;
    }

    /**
     * The pixels of both, as 0xAARRGGBB.
     *
     * @param wiped the columns that show the first picture, in {@link Mode#WIPE}
     */
    public int[] pixels(Mode mode, int wiped, Rendering tone) {
        return switch (mode) {
            case FIRST -> TonedPixels.of(first, tone);
            case SECOND -> TonedPixels.of(second, tone);
            case SIDE_BY_SIDE -> beside(TonedPixels.of(first, tone), TonedPixels.of(second, tone));
            case WIPE -> wiped(TonedPixels.of(first, tone), TonedPixels.of(second, tone), wiped);
            case DIFFERENCE -> TonedPixels.of(difference(), tone);
        };
    }

    /** The root of the mean of the squared differences of all channels. */
    public double rootMeanSquare() {
        double sum = 0;
        for (int i = 0; i < first.length; i++) {
            double apart = first[i] - second[i];
            sum += apart * apart;
        }
        return Math.sqrt(sum / first.length);
    }

    private float[] difference() {
        float[] apart = new float[first.length];
        for (int i = 0; i < apart.length; i++) {
            apart[i] = Math.abs(first[i] - second[i]);
        }
        return apart;
    }

    private int[] beside(int[] left, int[] right) {
        int[] both = new int[2 * left.length];
        for (int row = 0; row < height; row++) {
            System.arraycopy(left, row * width, both, 2 * row * width, width);
            System.arraycopy(right, row * width, both, (2 * row + 1) * width, width);
        }
        return both;
    }

    private int[] wiped(int[] left, int[] right, int columns) {
        int shown = Math.clamp(columns, 0, width);
        for (int row = 0; row < height; row++) {
            System.arraycopy(left, row * width, right, row * width, shown);
        }
        return right;
    }
}
