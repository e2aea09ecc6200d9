package dev.twister.mesh;

/**
 * Conversion of other programs' materials to Twister's reflectivity p. It is the exponent of highlights, and p / 128 is
 * the strength of reflections.
 */
final class Reflectivity {
    static final double MOST = 128;

    /** Corresponds to the reflectance of about 4 % of plastic at normal incidence. */
    static final double PLASTIC = 5;

    private Reflectivity() {}
}
