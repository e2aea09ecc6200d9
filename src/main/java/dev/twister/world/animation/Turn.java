package dev.twister.world.animation;

/**
 * How the user turns the camera.
 *
 * @param right in [-1, 1]; negative is left
 * @param down in [-1, 1]; negative is up
 * @param fast whether to turn faster
 */
public record Turn(double right, double down, boolean fast) {
    public static final Turn STILL = new Turn(0, 0, false);
}
