package dev.twister.render;

/** What a picture has where its view rays meet nothing. */
public enum Background {
    /** The scene's sky. */
    SKY,
    /**
     * Nothing: these pixels are transparent, and those of edges in part. The sky still lights the bodies and is
     * reflected in them.
     */
    NONE
}
