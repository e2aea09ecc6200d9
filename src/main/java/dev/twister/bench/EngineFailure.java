package dev.twister.bench;

/** An engine that could not be measured, and why. */
public record EngineFailure(String engine, String message) {
    private static final int MEGABYTE = 1 << 20;

    /** What there is to say where the JVM's memory is too little, and what to do. */
    public static String outOfMemory() {
        return "out of memory: this needs more than the "
                + Runtime.getRuntime().maxMemory() / MEGABYTE
                + " MB that the JVM may use; make it smaller, or allow more with TWISTER_JAVA_OPTIONS=-Xmx8g";
    }
}
