package dev.twister.mesh.input;

/**
 * Conversion of other programs' materials to Twister's reflectivity p. It is the exponent of highlights, and p / 128 is
 * the strength of reflections.
 */
public final class Reflectivity {
    public static final double MOST = 128;

    /** Corresponds to the reflectance of about 4 % of plastic at normal incidence. */
    public static final double PLASTIC = 5;

    private Reflectivity() {}
}
