package dev.twister.kernel;

/**
 * The kernel's argument {@code variant}: what a picture needs of the kernel, as bits. On a device it is a constant, so
 * that the code for everything else is not compiled.
 */
public final class Variant {
    /** Closest spheres are found in their hierarchy; otherwise by a loop over all. Both find the same hit. */
    public static final int WALK = 1;

    /** There are meshes. */
    public static final int MESHES = 2;

    /** Some material has more than color and reflectivity. */
    public static final int MATERIALS = 4;

    /** The output is linear floats; otherwise 8-bit ARGB. */
    public static final int LINEAR = 8;

    /** Paths are traced; implies {@link #MATERIALS}. */
    public static final int PATH = 16;

    /** There are several lights, or one whose share is not 1. */
    public static final int LIGHTS = 32;

    /** Some surface has maps besides its texture, or its mesh has vertex colors; implies {@link #MATERIALS}. */
    public static final int MAPS = 64;

    /** Some mesh is not opaque; implies {@link #MAPS} and {@link #MESHES}. */
    public static final int MASKS = 128;

    /** Some spheres are in one place, one of which transmits; implies {@link #MATERIALS}. */
    public static final int TWINS = 256;

    /** Some material has a finish, see {@link Layout#LOOK_FINISH}; only with {@link #PATH}; implies {@link #MAPS}. */
    public static final int FINISH = 512;

    private static final int VIEW_SHIFT = 10;

    private Variant() {}

    /** The bits of a stage or view, a constant of {@link Views}. */
    public static int of(int stageOrView) {
        return stageOrView << VIEW_SHIFT;
    }

    /** What a variant renders: a constant of {@link Views}. */
    public static int stageOrView(int variant) {
        return variant >> VIEW_SHIFT;
    }
}
