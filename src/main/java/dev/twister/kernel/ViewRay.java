package dev.twister.kernel;

/** Where a pixel lies on the viewport, whose shorter side runs from -1 to 1. */
public final class ViewRay {
    private ViewRay() {}

    /** From left to right; the middle column of an even width is exactly 0. */
    public static float u(float x, int width, int height) {
        return (x - width * 0.5f) * step(width, height);
    }

    /** From one pixel to the next. */
    public static float step(int width, int height) {
        return 2f / (width > height ? height : width);
    }

    /** From bottom to top. */
    public static float v(float y, int width, int height) {
        return (height * 0.5f - y) * step(width, height);
    }
}
