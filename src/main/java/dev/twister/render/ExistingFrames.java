package dev.twister.render;

/** What is done with numbered pictures of an earlier run. */
public enum ExistingFrames {
    REFUSED,
    REPLACED,
    /** Kept if they are whole and made from the same; otherwise rendered again. */
    KEPT
}
