package dev.twister.oracle;

import dev.twister.scene.Rgb;

/** Linear light in double precision. */
record Color(double red, double green, double blue) {
    static final Color BLACK = new Color(0, 0, 0);

    static Color of(Rgb color) {
        return new Color(color.red(), color.green(), color.blue());
    }

    Color plus(Color other) {
        return new Color(red + other.red, green + other.green, blue + other.blue);
    }

    Color times(double factor) {
        return new Color(factor * red, factor * green, factor * blue);
    }

    Color times(Color other) {
        return new Color(red * other.red, green * other.green, blue * other.blue);
    }

    double strongest() {
        return Math.max(red, Math.max(green, blue));
    }

    Color min(Color other) {
        return new Color(Math.min(red, other.red), Math.min(green, other.green), Math.min(blue, other.blue));
    }

    Color max(Color other) {
        return new Color(Math.max(red, other.red), Math.max(green, other.green), Math.max(blue, other.blue));
    }
}
