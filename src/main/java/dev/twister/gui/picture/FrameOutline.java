package dev.twister.gui.picture;

/** The size, in a view, of what a picture of other proportions shows: the field of view is over the shorter side. */
public record FrameOutline(double width, double height) {
    /** The outline of an output in a view of the same camera. */
    public static FrameOutline of(double viewWidth, double viewHeight, double outputWidth, double outputHeight) {
        double scale = Math.min(viewWidth, viewHeight) / Math.min(outputWidth, outputHeight);
        return new FrameOutline(outputWidth * scale, outputHeight * scale);
    }
}
