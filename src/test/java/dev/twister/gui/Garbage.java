package dev.twister.gui;

import java.lang.management.ManagementFactory;
import javax.management.JMException;
import javax.management.ObjectName;

/** Collects the heap's garbage in a JVM that ignores {@code System.gc()}. */
final class Garbage {
    private Garbage() {}

    /** Counts the living objects, before which the JVM collects the others. */
    static void collect() {
        try {
            Object _ = ManagementFactory.getPlatformMBeanServer()
                    .invoke(
                            new ObjectName("com.sun.management:type=DiagnosticCommand"),
                            "gcClassHistogram",
                            new Object[] {new String[0]},
                            new String[] {String[].class.getName()});
        } catch (JMException problem) {
            throw new IllegalStateException(problem);
        }
    }
}
