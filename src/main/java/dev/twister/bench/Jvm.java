package dev.twister.bench;

import com.sun.management.OperatingSystemMXBean;
import dev.twister.engine.JvmOptions;
import java.lang.management.ManagementFactory;

/** What this JVM says of itself. */
final class Jvm {
    private Jvm() {}

    static long machineMemory() {
        OperatingSystemMXBean system = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
        return system == null ? 0 : system.getTotalMemorySize();
    }

    static String vendor() {
        String own = System.getProperty("java.vendor.version", "");
        return System.getProperty("java.vendor", "unknown") + (own.isEmpty() ? "" : " (" + own + ")");
    }

    static String jit() {
        return (usesGraal() ? "Graal" : "C2") + ", " + System.getProperty("java.vm.name", "unknown JVM");
    }

    private static boolean usesGraal() {
        return JvmOptions.value("UseJVMCICompiler").map(Boolean::parseBoolean).orElse(false);
    }
}
