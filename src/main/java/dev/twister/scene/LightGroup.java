package dev.twister.scene;

import java.util.Map;

/**
 * Names of the groups of lights whose light can be kept apart. Lights, bodies that emit and the sky are in groups of
 * their own unless they name another one.
 */
public final class LightGroup {
    /** In no group by name. */
    public static final String NONE = "";

    /** The sky, the lights and the emitting bodies that are in no group by name. */
    public static final String SKY = "sky";

    public static final String LIGHTS = "lights";
    public static final String EMITTERS = "emitters";

    /** Without path tracing, what ambient light adds. */
    public static final String AMBIENT = "ambient";

    /** The names above, and whose light their layers hold. */
    public static final Map<String, String> RESERVED =
            Map.of(SKY, "the sky", LIGHTS, "other lights", EMITTERS, "other bodies that emit", AMBIENT, "ambient light");

    public static final int MAX_NAME_LENGTH = 20;

    private LightGroup() {}

    /** Whether a name can be that of a layer, or {@link #NONE}: letters, digits, {@code -} and {@code _} of ASCII. */
    public static boolean isName(String name) {
        return name.matches("[A-Za-z0-9_-]{0," + MAX_NAME_LENGTH + "}");
    }
}
