package dev.twister.world;

/**
 * Which way a person wants the camera to look.
 *
 * @param right in [-1, 1]; negative is to the left
 * @param down in [-1, 1]; negative is up
 * @param fast whether faster than usual
 */
public record Turn(double right, double down, boolean fast) {
    public static final Turn STILL = new Turn(0, 0, false);
}
