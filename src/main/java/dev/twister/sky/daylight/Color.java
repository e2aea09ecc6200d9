package dev.twister.sky.daylight;

/** Linear sRGB light, in whatever unit its maker says. */
public record Color(double red, double green, double blue) {
    static Color gray(double luminance) {
        return new Color(luminance, luminance, luminance);
    }

    /** CIE xyY to linear sRGB (IEC 61966-2-1); colors that sRGB cannot show are cut at 0. */
    static Color ofChromaticity(double x, double y, double luminance) {
        double bigX = x / y * luminance;
        double bigZ = (1 - x - y) / y * luminance;
        return new Color(
                Math.max(0, 3.2406 * bigX - 1.5372 * luminance - 0.4986 * bigZ),
                Math.max(0, -0.9689 * bigX + 1.8758 * luminance + 0.0415 * bigZ),
                Math.max(0, 0.0557 * bigX - 0.2040 * luminance + 1.0570 * bigZ));
    }

    public double luminance() {
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    }

    Color plus(Color other) {
        return new Color(red + other.red, green + other.green, blue + other.blue);
    }

    public Color times(double factor) {
        return new Color(factor * red, factor * green, factor * blue);
    }

    public Color times(Color filter) {
        return new Color(red * filter.red, green * filter.green, blue * filter.blue);
    }

    /** This color where {@code part} is 0, the other one where it is 1. */
    Color mixedWith(Color other, double part) {
        return times(1 - part).plus(other.times(part));
    }
}
