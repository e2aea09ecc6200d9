package dev.twister.scene.material;

/** What a material's reflectivity and its metallic part are to each other. */
public enum Reflectance {
    /** Metallic mixes a metal with the rest; a reflectivity of 0 is not given, so that Fresnel's equations decide. */
    MIXED,
    /** As mixed, with a reflectivity of 0 that is given: nothing is mirrored but by the metal. */
    CONSTANT,
    /** With a reflectivity, metallic only tints what is mirrored, as in files of version 3 and older. */
    TINTED
}
