package dev.twister.engine.vector.lanes;

import dev.twister.engine.JvmOptions;

/**
 * Whether the CPU multiplies and adds in one step, which those before 2013, and some small or virtual ones since, do
 * not.
 */
public final class FusedMultiplyAdd {
    /** A system property that overrides what the JVM says: {@code true} or {@code false}. */
    public static final String PROPERTY = "dev.twister.vector.fma";

    private FusedMultiplyAdd() {}

    /** As the JVM uses it; so where a JVM does not say. */
    public static boolean isFast() {
        String override = System.getProperty(PROPERTY);
        return override == null ? jvmUsesIt() : Boolean.parseBoolean(override);
    }

    private static boolean jvmUsesIt() {
        return JvmOptions.value("UseFMA").map(Boolean::parseBoolean).orElse(true);
    }
}
