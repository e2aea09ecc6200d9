package dev.twister.explain;

import java.util.Locale;

/** Where a ray of a path comes from. */
public enum RayKind {
    /** From the camera. */
    VIEW,
    REFLECTED,
    REFRACTED,
    /** By a matte surface, in path tracing. */
    SCATTERED,
    /** To a chosen emitter, in path tracing. */
    EMITTER;

    /** Its name in texts and files, such as {@code reflected}. */
    public String id() {
        return name().toLowerCase(Locale.ROOT);
    }
}
