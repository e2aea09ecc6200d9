package dev.twister.render;

/** What a picture has where its view rays meet nothing. */
public enum Background {
    /** The scene's sky. */
    SKY,
    /** Nothing: these pixels of a PNG are transparent. The sky still lights the bodies and is reflected in them. */
    NONE
}
