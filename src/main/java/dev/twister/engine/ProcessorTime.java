package dev.twister.engine;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** Processor time of threads, which other work on the machine does not lengthen as it does the time by the clock. */
public final class ProcessorTime {
    /** Windows counts in steps of 16 ms, longer than most frames. */
    private static final boolean IS_FINE = !System.getProperty("os.name", "").startsWith("Windows");

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final boolean IS_KNOWN = IS_FINE && THREADS.isCurrentThreadCpuTimeSupported();

    private ProcessorTime() {}

    /** Nanoseconds that the calling thread has spent so far; always 0 if that is not known. Takes about 0.5 us. */
    public static long ofThisThread() {
        return IS_KNOWN ? THREADS.getCurrentThreadCpuTime() : 0;
    }
}
