package dev.twister.sky;

/** Linear sRGB light, in whatever unit its maker says. */
record Colour(double red, double green, double blue) {
    static Colour grey(double luminance) {
        return new Colour(luminance, luminance, luminance);
    }

    /** CIE xyY to linear sRGB (IEC 61966-2-1); colours that sRGB cannot show are cut at 0. */
    static Colour ofChromaticity(double x, double y, double luminance) {
        double bigX = x / y * luminance;
        double bigZ = (1 - x - y) / y * luminance;
        return new Colour(
                Math.max(0, 3.2406 * bigX - 1.5372 * luminance - 0.4986 * bigZ),
                Math.max(0, -0.9689 * bigX + 1.8758 * luminance + 0.0415 * bigZ),
                Math.max(0, 0.0557 * bigX - 0.2040 * luminance + 1.0570 * bigZ));
    }

    double luminance() {
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    }

    Colour plus(Colour other) {
        return new Colour(red + other.red, green + other.green, blue + other.blue);
    }

    Colour times(double factor) {
        return new Colour(factor * red, factor * green, factor * blue);
    }

    Colour times(Colour filter) {
        return new Colour(red * filter.red, green * filter.green, blue * filter.blue);
    }

    /** This colour where {@code part} is 0, the other one where it is 1. */
    Colour mixedWith(Colour other, double part) {
        return times(1 - part).plus(other.times(part));
    }
}
