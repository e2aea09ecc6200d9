package dev.twister.engine;

import java.util.stream.IntStream;

/**
 * Light that few samples find, such as caustics, in the tiles of a picture: what the pixels in which no sample has
 * found it may miss. The pixels of a tile that differ far more than the others show how much that light is and how few
 * have found it; the fewer, the less is known.
 *
 * <p>Tiles see what their neighbors in the same row of tiles have found, and no others, so that rows of tiles can be
 * rendered apart.
 */
final class RareLight {
    /** Tiles to the left and right that count. */
    private static final int NEIGHBORS = 2;

    /** A pixel has found rare light if it deviates by this factor more than a usual pixel of its tile. */
    private static final double RARE = 16;

    /** Standard deviations of the number of finds that may be missing, as the number is a random one. */
    private static final double UNLUCKY = 2.5;

    private final int across;
    private final Finds[] tiles;

    /**
     * What a tile has found.
     *
     * @param sum of the finds' deviations, the means of their channels
     * @param squares sum of the squares of these
     * @param red of the sum; the other channels follow
     * @param pixels of the tile
     */
    record Finds(double sum, double squares, double red, double green, double blue, int pixels) {
        private static final Finds NONE = new Finds(0, 0, 0, 0, 0, 0);

        /**
         * The finds of a tile.
         *
         * @param deviations of linear radiance, three per pixel, 0 where the display does not show them
         */
        static Finds of(double[] deviations) {
            int pixels = deviations.length / 3;
            double roots = 0;
            for (int pixel = 0; pixel < pixels; pixel++) {
                roots += Math.sqrt(mean(deviations, pixel));
            }
            // Unlike the mean, hardly raised by a few large values.
            double usual = roots / pixels * (roots / pixels);
            double sum = 0;
            double squares = 0;
            double[] channels = new double[3];
            for (int pixel = 0; pixel < pixels; pixel++) {
                double deviation = mean(deviations, pixel);
                if (deviation > RARE * usual) {
                    sum += deviation;
                    squares += deviation * deviation;
                    for (int channel = 0; channel < 3; channel++) {
                        channels[channel] += deviations[3 * pixel + channel];
                    }
                }
            }
            return new Finds(sum, squares, channels[0], channels[1], channels[2], pixels);
        }

        private static double mean(double[] deviations, int pixel) {
            return (deviations[3 * pixel] + deviations[3 * pixel + 1] + deviations[3 * pixel + 2]) / 3;
        }

        Finds plus(Finds other) {
            return new Finds(
                    sum + other.sum,
                    squares + other.squares,
                    red + other.red,
                    green + other.green,
                    blue + other.blue,
                    pixels + other.pixels);
        }
    }

    /**
     * The rare light of a picture.
     *
     * @param across number of tiles beside each other
     * @param tiles from the top left
     */
    RareLight(int across, Finds[] tiles) {
        this.across = across;
        this.tiles = tiles;
    }

    /** Linear red, green and blue that a pixel of a tile may miss; 0 where nothing rare was found. */
    double[] missing(int tile) {
        int column = tile % across;
        Finds near = IntStream.rangeClosed(Math.max(0, column - NEIGHBORS), Math.min(across - 1, column + NEIGHBORS))
                .mapToObj(beside -> tiles[tile - column + beside])
                .reduce(Finds.NONE, Finds::plus);
        if (near.sum() == 0) {
            return new double[3];
        }
        double finds = near.sum() * near.sum() / near.squares();
        double more = UNLUCKY * (Math.sqrt(finds) + 1) / finds / near.pixels();
        return new double[] {more * near.red(), more * near.green(), more * near.blue()};
    }
}
