package dev.twister.scene;

/**
 * How surfaces are lit.
 *
 * @param ambient the ambient strength a in [0, 1], {@value #DEFAULT_AMBIENT} where a file is silent
 */
public record Shading(double ambient) {
    public static final double DEFAULT_AMBIENT = 0.2;
    public static final Shading DEFAULT = new Shading(DEFAULT_AMBIENT);
}
