package dev.twister.scene;

/**
 * How a body is turned, in degrees: rolled about z, then pitched about x, then turned about y.
 *
 * @param yawDegrees about y; positive turns to the right
 * @param pitchDegrees about x; positive looks down
 * @param rollDegrees about z; positive turns from x to y
 */
public record Rotation(double yawDegrees, double pitchDegrees, double rollDegrees) {
    public static final Rotation NONE = new Rotation(0, 0, 0);

    public Rotation withYawDegrees(double newYawDegrees) {
        return new Rotation(newYawDegrees, pitchDegrees, rollDegrees);
    }

    public Rotation withPitchDegrees(double newPitchDegrees) {
        return new Rotation(yawDegrees, newPitchDegrees, rollDegrees);
    }

    public Rotation withRollDegrees(double newRollDegrees) {
        return new Rotation(yawDegrees, pitchDegrees, newRollDegrees);
    }
}
