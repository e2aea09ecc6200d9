package dev.twister.mesh;

/**
 * Conversion of other programs' materials to Twister's reflectivity p. It is the exponent of highlights, and p / 128 is
 * the strength of reflections.
 */
final class Reflectivity {
    static final double MOST = 128;

    /** Corresponds to the reflectance of about 4 % of plastic at normal incidence. */
    static final double PLASTIC = 5;

    /** Below the maximum: reflections here do not take on a metal's color, so the rest must show it. */
    private static final double METAL = 96;

    private Reflectivity() {}

    /** The reflectivity for a metallic value and a roughness in [0, 1]; rough surfaces hardly reflect. */
    static double of(double metallic, double roughness) {
        return (PLASTIC + metallic * (METAL - PLASTIC)) * (1 - roughness);
    }
}
