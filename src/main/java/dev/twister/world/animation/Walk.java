package dev.twister.world.animation;

/**
 * How the user moves the camera.
 *
 * @param right in [-1, 1]; negative is left
 * @param up in [-1, 1]; negative is down
 * @param forward in [-1, 1]; negative is back
 * @param running whether to move faster
 */
public record Walk(double right, double up, double forward, boolean running) {
    public static final Walk STILL = new Walk(0, 0, 0, false);

    public boolean isStill() {
        return right == 0 && up == 0 && forward == 0;
    }
}
