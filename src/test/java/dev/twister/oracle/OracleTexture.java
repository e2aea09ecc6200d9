package dev.twister.oracle;

import dev.twister.scene.material.Sampler;
import dev.twister.scene.material.Wrap;
import dev.twister.sky.Skybox;

/** A picture on a surface. */
record OracleTexture(Skybox picture, Sampler sampler) {
    OracleTexture(Skybox picture) {
        this(picture, Sampler.DEFAULT);
    }

    /** (u, v) = (0, 0) is the upper left corner of the first texel. */
    Color color(double u, double v) {
        if (sampler.nearest()) {
            return texel(Math.floor(u * picture.width()), Math.floor(v * picture.height()));
        }
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
                * (wrapped((long) row, picture.height(), sampler.down()) * picture.width()
                        + wrapped((long) column, picture.width(), sampler.across()));
        return new Color(picture.radiance()[at], picture.radiance()[at + 1], picture.radiance()[at + 2]);
    }

    private static int wrapped(long place, int size, Wrap wrap) {
        int doubled = Math.floorMod(place, 2 * size);
        return switch (wrap) {
            case REPEAT -> Math.floorMod(place, size);
            case CLAMP -> (int) Math.clamp(place, 0L, size - 1L);
            case MIRROR -> doubled < size ? doubled : 2 * size - 1 - doubled;
        };
    }
}
