package dev.twister.mesh;

/** Colors of vertices and faces in formats that store them as a screen shows them. */
final class ColorCurve {
    private ColorCurve() {}

    /** The linear value of an sRGB value, both in [0, 1]. */
    static double linear(double encoded) {
        double value = Math.clamp(encoded, 0.0, 1.0);
        return value <= 0.04045 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4);
    }
}
