package dev.twister.explain;

import dev.twister.kernel.Layout;
import dev.twister.scene.Vector3;

/**
 * A ray from a surface to a point of the light's disc.
 *
 * @param target the point, in the scene's meters
 * @param light what reaches the surface along it: 1, 0 where it is blocked, between them where bodies on its way
 *     transmit
 * @param blocker the nearest body on its way; {@link Layout#NOTHING} where all light passes
 */
public record LightSample(Vector3 target, double light, int blocker) {}
