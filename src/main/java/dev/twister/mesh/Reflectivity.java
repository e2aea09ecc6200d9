package dev.twister.mesh;

/**
 * Twister's reflectivity p, which is the exponent of highlights and, over 128, the mirror ratio, for other programs'
 * materials.
 */
final class Reflectivity {
    static final double MOST = 128;

    /** About the 4 % that plastic mirrors when it is looked at from the front. */
    static final double PLASTIC = 5;

    /** Less than all: what a metal mirrors here has not its color, so that the rest must show it. */
    private static final double METAL = 96;

    private Reflectivity() {}

    /** For a metallic part and a roughness in [0, 1]: something rough hardly mirrors. */
    static double of(double metallic, double roughness) {
        return (PLASTIC + metallic * (METAL - PLASTIC)) * (1 - roughness);
    }
}
