package dev.twister.engine.vector.frame;

/** What makes frames faster and leaves them as they are, rounding aside. */
public enum Shortcut {
    /**
     * Bodies that no ray of a tile can meet, or that cannot shade it, are left out: {@code Hull}; sky and ground tiles
     * need it.
     */
    CULLING,

    /** Tiles whose view rays all meet the sky: {@code WholeTiles}. */
    SKY_TILES,

    /** Tiles whose view rays all meet the ground: {@code GroundAlone}. */
    GROUND_TILES,

    /** Such tiles with nothing between them and the light: {@code OpenGround}. */
    OPEN_GROUND,

    /**
     * Directions of a tile's view rays as columns and rows of the sky by polynomials: {@code SkyChart}; sky tiles need
     * it.
     */
    SKY_CHART,

    /** All texels that a tile looks at as two vectors: {@code SkyWindow}. */
    SKY_WINDOW,

    /** All texels that a packet looks at as a patch: {@code SkyRows}, {@code SkyPatches}. */
    SKY_PATCHES,

    /** Blocked samples by conics: {@code ShadowConics}, {@code LoneCandidates}. */
    CONICS,

    /** Samples that are surely blocked or surely not are left out: {@code ShadowRange}; it needs conics. */
    SAMPLE_RANGES
}
