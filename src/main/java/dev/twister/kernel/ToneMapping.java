package dev.twister.kernel;

/** From linear colour, exposure applied, to what a pixel shows. */
public final class ToneMapping {
    public static final int CLAMP = 0;
    public static final int REINHARD = 1;
    public static final int ACES = 2;

    private ToneMapping() {}
}
