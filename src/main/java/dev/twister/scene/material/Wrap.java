package dev.twister.scene.material;

/** What a map shows beyond its borders. */
public enum Wrap {
    REPEAT,
    /** The border's own texels. */
    CLAMP,
    /** Every second copy is mirrored. */
    MIRROR
}
