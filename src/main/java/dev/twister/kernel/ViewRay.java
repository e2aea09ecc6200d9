package dev.twister.kernel;

/** Where a pixel lies on the viewport, whose shorter side runs from -1 to 1. */
public final class ViewRay {
    private ViewRay() {}

    /** From left to right; the middle column of an even width is exactly 0. */
    public static float u(float x, int width, int height) {
        return width > height ? (x - width * 0.5f + height * 0.5f) / height * 2f - 1f : x / width * 2f - 1f;
    }

    /** From bottom to top. */
    public static float v(float y, int width, int height) {
        return width > height ? -(y / height * 2f - 1f) : -((y - height * 0.5f + width * 0.5f) / width * 2f - 1f);
    }
}
