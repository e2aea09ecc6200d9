package dev.twister.scene;

/** How linear color becomes [0, 1]; the formulas are the kernel's. */
public enum ToneMap {
    /** {@code min(1, c)}, the paper's. */
    CLAMP,
    /** Reinhard et al. 2002: {@code c / (1 + c)}. */
    REINHARD,
    /** Narkowicz's fit (2016) of the ACES filmic curve. */
    ACES
}
