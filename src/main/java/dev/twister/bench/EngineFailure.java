package dev.twister.bench;

/** An engine that could not be measured, and the reason. */
public record EngineFailure(String engine, String message) {
    private static final int MEGABYTE = 1 << 20;

    /** The message for a JVM that runs out of memory, with what to do. */
    public static String outOfMemory() {
        return "out of memory: this needs more than the "
                + Runtime.getRuntime().maxMemory() / MEGABYTE
                + " MB that the JVM may use; make it smaller, or allow more with TWISTER_JAVA_OPTIONS=-Xmx8g";
    }
}
