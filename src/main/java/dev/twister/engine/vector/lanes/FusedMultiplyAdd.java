package dev.twister.engine.vector.lanes;

import dev.twister.engine.JvmOptions;

/** Whether the CPU has a fused multiply-add. CPUs older than 2013 and some small or virtual ones lack it. */
public final class FusedMultiplyAdd {
    /** System property that overrides the JVM's setting: {@code true} or {@code false}. */
    public static final String PROPERTY = "dev.twister.vector.fma";

    private FusedMultiplyAdd() {}

    /** The JVM's setting; true where it is unknown. */
    public static boolean isFast() {
        String override = System.getProperty(PROPERTY);
        return override == null ? jvmUsesIt() : Boolean.parseBoolean(override);
    }

    private static boolean jvmUsesIt() {
        return JvmOptions.value("UseFMA").map(Boolean::parseBoolean).orElse(true);
    }
}
