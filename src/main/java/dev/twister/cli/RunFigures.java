package dev.twister.cli;

import dev.twister.files.TwisterVersion;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryType;
import java.time.Duration;
import java.util.Locale;

/** What {@code --verbose} prints after a command that begins now: version, time and memory. */
final class RunFigures {
    private static final double MILLIS_PER_SECOND = 1000;
    private static final double BYTES_PER_MEBIBYTE = 1 << 20;

    private final long start = System.nanoTime();

    void print(PrintWriter err) {
        ProcessHandle.Info process = ProcessHandle.current().info();
        double processorSeconds =
                process.totalCpuDuration().orElse(Duration.ZERO).toMillis() / MILLIS_PER_SECOND;
        err.printf(
                Locale.ROOT,
                "twister %s on Java %s (%s): %.1f s, %.1f s of processor time with the start, heap up to %.0f MiB%n",
                TwisterVersion.text(),
                Runtime.version(),
                System.getProperty("java.vm.name"),
                Duration.ofNanos(System.nanoTime() - start).toMillis() / MILLIS_PER_SECOND,
                processorSeconds,
                heapBytes() / BYTES_PER_MEBIBYTE);
    }

    /** The sum of the most that each part of the heap held. */
    private static long heapBytes() {
        return ManagementFactory.getMemoryPoolMXBeans().stream()
                .filter(pool -> pool.getType() == MemoryType.HEAP)
                .map(pool -> pool.getPeakUsage())
                .mapToLong(usage -> usage.getUsed())
                .sum();
    }
}
