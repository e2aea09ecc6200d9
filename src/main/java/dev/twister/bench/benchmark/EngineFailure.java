package dev.twister.bench.benchmark;

/** An engine that could not be measured, and the reason. */
public record EngineFailure(String engine, String message) {
    private static final int MEGABYTE = 1 << 20;
    private static final int GIGABYTE = 1 << 30;
    private static final long LEAST_GIGABYTES = 8;

    /** The message for a JVM that runs out of memory, with what to do. */
    public static String outOfMemory() {
        return outOfMemory(Runtime.getRuntime().maxMemory());
    }

    public static String outOfMemory(long maxBytes) {
        return "out of memory: this needs more than the " + maxBytes / MEGABYTE
                + " MB that the JVM may use; make it smaller, or allow more with TWISTER_JAVA_OPTIONS=-Xmx"
                + Math.max(LEAST_GIGABYTES, 2 * Math.ceilDiv(maxBytes, GIGABYTE)) + "g";
    }
}
