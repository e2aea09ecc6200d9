package dev.twister.oracle;

import dev.twister.sky.Skybox;

/** A picture on a surface, with bilinear filtering, repeating in both directions. */
record OracleTexture(Skybox picture) {
    /** (u, v) = (0, 0) is the upper left corner of the first texel. */
    Color color(double u, double v) {
        double column = u * picture.width() - 0.5;
        double row = v * picture.height() - 0.5;
        double left = Math.floor(column);
        double top = Math.floor(row);
        double toRight = column - left;
        double toBottom = row - top;
        return texel(left, top)
                .times((1 - toRight) * (1 - toBottom))
                .plus(texel(left + 1, top).times(toRight * (1 - toBottom)))
                .plus(texel(left, top + 1).times((1 - toRight) * toBottom))
                .plus(texel(left + 1, top + 1).times(toRight * toBottom));
    }

    /** The nearest v at which only rows of the picture itself count. */
    double between(double v) {
        double half = 0.5 / picture.height();
        return Math.clamp(v, half, 1 - half);
    }

    private Color texel(double column, double row) {
        int at = 3
                * (Math.floorMod((long) row, picture.height()) * picture.width()
                        + Math.floorMod((long) column, picture.width()));
        return new Color(picture.radiance()[at], picture.radiance()[at + 1], picture.radiance()[at + 2]);
    }
}
