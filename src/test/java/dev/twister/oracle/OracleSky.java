package dev.twister.oracle;

import dev.twister.scene.Light;
import dev.twister.sky.Skybox;
import java.util.List;

/** Looks up the panorama in a direction. */
final class OracleSky {
    private final Skybox sky;
    private final double turn;
    private final double strength;
    private final List<Light> suns;

    OracleSky(Skybox sky, double rotationDegrees, double strength) {
        this(sky, rotationDegrees, strength, List.of());
    }

    /** @param suns lights before the panorama */
    OracleSky(Skybox sky, double rotationDegrees, double strength, List<Light> suns) {
        this.suns = suns;
        this.sky = sky;
        turn = rotationDegrees / 360;
        this.strength = strength;
    }

    Color color(Vector direction) {
        Color color = panorama(direction);
        for (Light sun : suns) {
            double halfAngle = Math.toRadians(sun.shape().angularDiameterDegrees() / 2);
            if (direction.dot(OracleTracer.vector(sun.shape().toward())) > Math.cos(halfAngle)) {
                double strongest = sun.strength().orElse(1.0) / Math.pow(Math.sin(halfAngle), 2);
                color = color.plus(Color.of(sun.color()).times(strongest));
            }
        }
        return color;
    }

    private Color panorama(Vector direction) {
        double u = 0.5 + Math.atan2(direction.x(), direction.z()) / (2 * Math.PI) - turn;
        double v = 0.5 - Math.asin(Math.clamp(direction.y(), -1, 1)) / Math.PI;
        double column = u * sky.width() - 0.5;
        double row = v * sky.height() - 0.5;
        double left = Math.floor(column);
        double top = Math.floor(row);
        double toRight = column - left;
        double toBottom = row - top;
        return texel(left, top)
                .times((1 - toRight) * (1 - toBottom))
                .plus(texel(left + 1, top).times(toRight * (1 - toBottom)))
                .plus(texel(left, top + 1).times((1 - toRight) * toBottom))
                .plus(texel(left + 1, top + 1).times(toRight * toBottom))
                .times(strength);
    }

    /** Columns wrap around the horizon; rows are clamped. */
    private Color texel(double column, double row) {
        int wrapped = Math.floorMod((int) column, sky.width());
        int clamped = Math.clamp((int) row, 0, sky.height() - 1);
        int at = 3 * (clamped * sky.width() + wrapped);
        return new Color(sky.radiance()[at], sky.radiance()[at + 1], sky.radiance()[at + 2]);
    }
}
