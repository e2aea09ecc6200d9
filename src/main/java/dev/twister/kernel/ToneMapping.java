package dev.twister.kernel;

/** Tone maps; the numbers are the order of the scene's {@code ToneMap}. */
public final class ToneMapping {
    private ToneMapping() {}
}
