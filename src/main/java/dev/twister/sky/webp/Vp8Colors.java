package dev.twister.sky.webp;

/**
 * Converts a frame to red, green and blue, by the arithmetic of libwebp, with chroma interpolated between its values.
 */
final class Vp8Colors {
    private static final int OPAQUE = 0xff << 24;

    private Vp8Colors() {}

    static int[] argb(Vp8Plane luma, Vp8Plane u, Vp8Plane v, int width, int height) {
        int[] argb = new int[width * height];
        int[] us = new int[width];
        int[] vs = new int[width];
        int chromaHeight = (height + 1) >> 1;
        for (int row = 0; row < height; row++) {
            int near = row >> 1;
            int far = Math.clamp((row & 1) == 0 ? near - 1 : near + 1, 0, chromaHeight - 1);
            interpolate(u, u.at(0, near), u.at(0, far), us);
            interpolate(v, v.at(0, near), v.at(0, far), vs);
            int from = luma.at(0, row);
            for (int column = 0; column < width; column++) {
                argb[row * width + column] = color(luma.value(from + column), us[column], vs[column]);
            }
        }
        return argb;
    }

    /** Chroma of a row of texels, from the row of chroma that is near and the one that is farther. */
    private static void interpolate(Vp8Plane chroma, int near, int far, int[] row) {
        int width = row.length;
        for (int column = 0; column < width; column++) {
            int at = column >> 1;
            int beside = (column & 1) == 0 ? at - 1 : at + 1;
            int nearest = chroma.value(near + at);
            int across = chroma.value(far + at);
            if (beside < 0 || beside > (width - 1) >> 1) {
                row[column] = (3 * nearest + across + 2) >> 2;
            } else {
                int nearBeside = chroma.value(near + beside);
                int farBeside = chroma.value(far + beside);
                int all = nearest + across + nearBeside + farBeside + 8;
                row[column] = (((all + 2 * (nearBeside + across)) >> 3) + nearest) >> 1;
            }
        }
    }

    private static int color(int y, int u, int v) {
        int luma = (y * 19_077) >> 8;
        int red = luma + ((v * 26_149) >> 8) - 14_234;
        int green = luma - ((u * 6_419) >> 8) - ((v * 13_320) >> 8) + 8_708;
        int blue = luma + ((u * 33_050) >> 8) - 17_685;
        return OPAQUE | channel(red) << 16 | channel(green) << 8 | channel(blue);
    }

    private static int channel(int value) {
        return Math.clamp(value >> 6, 0, 255);
    }
}
