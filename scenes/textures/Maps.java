import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import javax.imageio.ImageIO;

/**
 * Makes the maps of the scene {@code maps.json}: heights and roughness of bricks, a grille with holes, and panes that
 * shine. Run in the project's folder: {@code java scenes/textures/Maps.java}.
 */
public class Maps {
    private static final int SIZE = 256;

    /** A picture as a function of places in [0, 1). */
    private interface Picture {
        int argb(double u, double v);
    }

    public static void main(String[] arguments) throws IOException {
        write("brick-color", BufferedImage.TYPE_INT_RGB, Maps::brickColor);
        write("brick-height", BufferedImage.TYPE_INT_RGB, (u, v) -> gray(0.08 * wear(u, v) + 0.9 * depth(u, v)));
        write("brick-rough", BufferedImage.TYPE_INT_RGB, Maps::brickRough);
        write("grille", BufferedImage.TYPE_INT_ARGB, Maps::grille);
        write("panes", BufferedImage.TYPE_INT_RGB, Maps::panes);
    }

    private static void write(String name, int type, Picture picture) throws IOException {
        BufferedImage image = new BufferedImage(SIZE, SIZE, type);
        for (int row = 0; row < SIZE; row++) {
            for (int column = 0; column < SIZE; column++) {
                image.setRGB(column, row, picture.argb((column + 0.5) / SIZE, (row + 0.5) / SIZE));
            }
        }
        ImageIO.write(image, "png", new File("scenes/textures/" + name + ".png"));
    }

    /** Distance from the nearest joint, 0 to 1 on a brick's face: four courses of two bricks, every second one moved. */
    private static double depth(double u, double v) {
        double course = 4 * v;
        double along = 2 * u + (Math.floor(course) % 2 == 0 ? 0 : 0.5);
        double across = Math.min(fraction(along), 1 - fraction(along)) * 2;
        double down = Math.min(fraction(course), 1 - fraction(course));
        return Math.clamp((Math.min(across, down) - 0.04) / 0.06, 0.0, 1.0);
    }

    private static int brickColor(double u, double v) {
        double brick = depth(u, v);
        double wear = 0.85 + 0.15 * wear(u, v);
        double tone = 0.8 + 0.2 * wear(Math.floor(2 * u + 0.5) / 3, Math.floor(4 * v) / 5);
        return rgb(
                mix(0.62, 0.66 * wear * tone, brick),
                mix(0.6, 0.27 * wear * tone, brick),
                mix(0.56, 0.2 * wear, brick));
    }

    /** Glazed bricks between rough joints; nothing is metal. */
    private static int brickRough(double u, double v) {
        return rgb(1, mix(1, 0.35 + 0.2 * wear(u, v), depth(u, v)), 0);
    }

    /** Bars along both diagonals, and holes between them. */
    private static int grille(double u, double v) {
        double up = fraction(2 * (u + v));
        double down = fraction(2 * (u - v) + 2);
        boolean bar = Math.min(up, 1 - up) < 0.12 || Math.min(down, 1 - down) < 0.12;
        return (bar ? 0xff000000 : 0) | rgb(0.75, 0.6, 0.3) & 0xffffff;
    }

    /** Four by four panes of warm and cold light in a dark frame. */
    private static int panes(double u, double v) {
        double across = fraction(4 * u);
        double down = fraction(4 * v);
        boolean frame = Math.min(Math.min(across, 1 - across), Math.min(down, 1 - down)) < 0.1;
        double kind = wear(Math.floor(4 * u) / 4 + 0.1, Math.floor(4 * v) / 4 + 0.2);
        return frame ? 0 : kind < 0.35 ? rgb(0.1, 0.1, 0.15) : kind < 0.7 ? rgb(1, 0.6, 0.25) : rgb(0.4, 0.7, 1);
    }

    /** Smooth noise in [0, 1] that repeats at 1. */
    private static double wear(double u, double v) {
        double sum = 0;
        for (int wave = 1; wave <= 5; wave++) {
            sum += Math.sin(2 * Math.PI * (wave * 3 * u + (7 - wave) * 2 * v) + wave * wave)
                    * Math.cos(2 * Math.PI * ((wave + 4) * v - wave * 2 * u) + 2 * wave);
        }
        return Math.clamp(0.5 + sum / 5, 0.0, 1.0);
    }

    private static double mix(double a, double b, double part) {
        return a + part * (b - a);
    }

    private static double fraction(double value) {
        return value - Math.floor(value);
    }

    private static int gray(double value) {
        return rgb(value, value, value);
    }

    private static int rgb(double red, double green, double blue) {
        return 0xff000000 | level(red) << 16 | level(green) << 8 | level(blue);
    }

    private static int level(double value) {
        return (int) Math.round(255 * Math.clamp(value, 0.0, 1.0));
    }
}
