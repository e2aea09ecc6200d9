package dev.twister.engine;

import com.sun.management.HotSpotDiagnosticMXBean;
import java.lang.management.ManagementFactory;
import java.util.Optional;

/** The options that this JVM runs with, from the command line and the environment. */
public final class JvmOptions {
    private JvmOptions() {}

    /**
     * The value of the option of that name, without {@code -XX:}; empty where the JVM has no such option, or tells
     * none.
     */
    public static Optional<String> value(String name) {
        HotSpotDiagnosticMXBean diagnostics = ManagementFactory.getPlatformMXBean(HotSpotDiagnosticMXBean.class);
        if (diagnostics == null) {
            return Optional.empty();
        }
        try {
            return Optional.of(diagnostics.getVMOption(name).getValue());
        } catch (IllegalArgumentException noSuchOption) {
            return Optional.empty();
        }
    }
}
