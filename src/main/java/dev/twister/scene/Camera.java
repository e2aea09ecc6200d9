package dev.twister.scene;

/**
 * Where a picture is seen from.
 *
 * @param position the rays' origin, in metres
 * @param yawDegrees turn about y; positive looks right
 * @param pitchDegrees turn about x, in [-90, 90]; positive looks down
 * @param fieldOfViewDegrees the angle over the shorter side of the picture, in [1, 179]
 */
public record Camera(Vector3 position, double yawDegrees, double pitchDegrees, double fieldOfViewDegrees) {}
