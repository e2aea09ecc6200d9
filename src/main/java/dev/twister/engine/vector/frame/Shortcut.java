package dev.twister.engine.vector.frame;

/** Optional optimizations that leave the picture as it is, rounding aside. */
public enum Shortcut {
    /**
     * Skip bodies that no ray of a tile can hit or that cannot shade it: {@code Hull}. Sky and ground tiles need it.
     */
    CULLING,

    /** Tiles whose view rays all hit the sky: {@code WholeTiles}. */
    SKY_TILES,

    /** Tiles whose view rays all hit the ground: {@code GroundAlone}. */
    GROUND_TILES,

    /** Ground tiles with no occluder between them and the light: {@code OpenGround}. */
    OPEN_GROUND,

    /** Polynomials from a tile's pixels to columns and rows of the sky: {@code SkyChart}. Sky tiles need it. */
    SKY_CHART,

    /** All texels of a tile in two vectors: {@code SkyWindow}. */
    SKY_WINDOW,

    /** All texels of a packet as one patch: {@code SkyRows}, {@code SkyPatches}. */
    SKY_PATCHES,

    /** Blocked shadow samples by conics: {@code ShadowConics}, {@code LoneCandidates}. */
    CONICS,

    /** Skip samples that are certainly blocked or certainly visible: {@code ShadowRange}. Needs {@link #CONICS}. */
    SAMPLE_RANGES
}
