import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.Map;
import javax.imageio.ImageIO;

/** Makes the textures of scenes/planets.json beside itself: {@code java scenes/textures/Planets.java}. */
public final class Planets {
    private static final int WIDTH = 512;
    private static final int HEIGHT = WIDTH / 2;

    /** The color of a place on the unit sphere. */
    private interface Planet {
        double[] color(double x, double y, double z);
    }

    private Planets() {}

    public static void main(String[] arguments) throws IOException {
        Map<String, Planet> planets = Map.of(
                "earth", Planets::earth, "mars", Planets::mars, "jupiter", Planets::jupiter, "moon", Planets::moon);
        for (Map.Entry<String, Planet> planet : planets.entrySet()) {
            File file = new File("scenes/textures", planet.getKey() + ".png");
            ImageIO.write(picture(planet.getValue()), "png", file);
        }
    }

    private static BufferedImage picture(Planet planet) {
        BufferedImage picture = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < HEIGHT; row++) {
            double elevation = Math.PI * (0.5 - (row + 0.5) / HEIGHT);
            for (int column = 0; column < WIDTH; column++) {
                double azimuth = 2 * Math.PI * (column + 0.5) / WIDTH;
                double[] color = planet.color(
                        Math.cos(elevation) * Math.sin(azimuth),
                        Math.sin(elevation),
                        Math.cos(elevation) * Math.cos(azimuth));
                picture.setRGB(column, row, byteOf(color[0]) << 16 | byteOf(color[1]) << 8 | byteOf(color[2]));
            }
        }
        return picture;
    }

    private static double[] earth(double x, double y, double z) {
        double height = octaves(1, 1.6 * x, 1.6 * y, 1.6 * z, 7);
        double cold = Math.abs(y) + 0.25 * (octaves(2, 4 * x, 4 * y, 4 * z, 4) - 0.5);
        double[] sea = mix(rgb(0x0b2a5c), rgb(0x1f6fa8), step(0.36, 0.52, height));
        double dry = step(0.5, 0.75, octaves(3, 2 * x, 2 * y, 2 * z, 4) + 0.2 - Math.abs(Math.abs(y) - 0.35));
        double[] low = mix(rgb(0x2f6b2a), rgb(0xc2a565), dry);
        double[] land = mix(low, rgb(0x6d5a45), step(0.6, 0.72, height));
        double[] ground = mix(sea, land, step(0.515, 0.525, height));
        double[] white = mix(ground, rgb(0xf4f7fa), step(0.84, 0.9, cold));
        double cloud = octaves(4, 2.2 * x + 0.4 * y, 4.5 * y, 2.2 * z, 6);
        return mix(white, rgb(0xffffff), 0.9 * step(0.58, 0.78, cloud));
    }

    private static double[] mars(double x, double y, double z) {
        double height = octaves(11, 2 * x, 2 * y, 2 * z, 7);
        double[] ground = mix(rgb(0x7a3418), rgb(0xd98a4e), step(0.32, 0.68, height));
        double[] dark = mix(ground, rgb(0x4a2618), 0.7 * step(0.55, 0.7, octaves(12, 3 * x, 3 * y, 3 * z, 5)));
        double cold = Math.abs(y) + 0.12 * (octaves(13, 6 * x, 6 * y, 6 * z, 4) - 0.5);
        return mix(dark, rgb(0xf3ece4), step(0.93, 0.96, cold));
    }

    private static double[] jupiter(double x, double y, double z) {
        double swirl = octaves(21, 3 * x, 9 * y, 3 * z, 6) - 0.5;
        double band = 0.5 + 0.5 * Math.sin(17 * y + 2.2 * swirl + 1.3 * Math.sin(5 * y));
        double[] color = mix(rgb(0xa8734a), rgb(0xf0dfc0), step(0.2, 0.85, band));
        double[] streaked = mix(color, rgb(0xd9b48a), step(0.5, 0.62, octaves(22, 4 * x, 26 * y, 4 * z, 4)));
        double spotX = x - 0.55;
        double spotY = 2.2 * (y + 0.34);
        double spot = Math.sqrt(spotX * spotX + spotY * spotY) + 0.05 * swirl;
        return z > 0 ? mix(rgb(0xb5482c), streaked, step(0.16, 0.25, spot)) : streaked;
    }

    private static double[] moon(double x, double y, double z) {
        double[] seas = mix(rgb(0x6a6a6e), rgb(0xbdbab4), step(0.42, 0.58, octaves(31, 1.7 * x, 1.7 * y, 1.7 * z, 6)));
        return mix(seas, rgb(0x3e3e42), craters(x, y, z));
    }

    /** How dark the floor of the nearest crater is, in [-1, 1]: less than 0 is its bright rim. */
    private static double craters(double x, double y, double z) {
        double dark = 0;
        for (int scale = 3; scale <= 12; scale *= 2) {
            long cellX = (long) Math.floor(scale * x);
            long cellY = (long) Math.floor(scale * y);
            long cellZ = (long) Math.floor(scale * z);
            for (int near = 0; near < 27; near++) {
                long i = cellX + near % 3 - 1;
                long j = cellY + near / 3 % 3 - 1;
                long k = cellZ + near / 9 - 1;
                double away = Math.sqrt(square(scale * x - i - number(40 + scale, i, j, k))
                        + square(scale * y - j - number(41 + scale, i, j, k))
                        + square(scale * z - k - number(42 + scale, i, j, k)));
                double radius = 0.15 + 0.3 * number(43 + scale, i, j, k);
                dark += 0.55 * (1 - step(0.6 * radius, 0.9 * radius, away));
                dark -= 0.5 * step(0.8 * radius, radius, away) * (1 - step(radius, 1.25 * radius, away));
            }
        }
        return Math.clamp(dark, -0.8, 0.8);
    }

    private static double square(double x) {
        return x * x;
    }

    /** Value noise of several scales, about 0.5. */
    private static double octaves(int seed, double x, double y, double z, int count) {
        double sum = 0;
        double weights = 0;
        for (int octave = 0; octave < count; octave++) {
            double scale = 1 << octave;
            sum += noise(seed + octave, scale * x, scale * y, scale * z) / scale;
            weights += 1 / scale;
        }
        return 0.5 + 1.4 * (sum / weights - 0.5);
    }

    private static double noise(int seed, double x, double y, double z) {
        long i = (long) Math.floor(x);
        long j = (long) Math.floor(y);
        long k = (long) Math.floor(z);
        double sum = 0;
        for (int corner = 0; corner < 8; corner++) {
            int a = corner & 1;
            int b = corner >> 1 & 1;
            int c = corner >> 2;
            sum += number(seed, i + a, j + b, k + c) * smooth(x - i, a) * smooth(y - j, b) * smooth(z - k, c);
        }
        return sum;
    }

    private static double smooth(double x, int corner) {
        double part = x * x * (3 - 2 * x);
        return corner == 0 ? 1 - part : part;
    }

    /** In [0, 1), by a hash. */
    private static double number(int seed, long i, long j, long k) {
        long hash = seed * 0x9e3779b97f4a7c15L ^ i * 0xbf58476d1ce4e5b9L ^ j * 0x94d049bb133111ebL ^ k * 0xd6e8feb86659fd93L;
        hash = (hash ^ hash >>> 32) * 0xd6e8feb86659fd93L;
        hash = (hash ^ hash >>> 32) * 0xd6e8feb86659fd93L;
        return (hash >>> 11) * 0x1p-53;
    }

    private static double step(double from, double to, double x) {
        double part = Math.clamp((x - from) / (to - from), 0.0, 1.0);
        return part * part * (3 - 2 * part);
    }

    private static double[] mix(double[] a, double[] b, double part) {
        double[] mixed = new double[3];
        for (int channel = 0; channel < 3; channel++) {
            mixed[channel] = a[channel] + part * (b[channel] - a[channel]);
        }
        return mixed;
    }

    private static double[] rgb(int color) {
        return new double[] {(color >> 16) / 255.0, (color >> 8 & 255) / 255.0, (color & 255) / 255.0};
    }

    private static int byteOf(double value) {
        return (int) Math.round(255 * Math.clamp(value, 0.0, 1.0));
    }
}
