package dev.twister.engine;

import com.sun.management.HotSpotDiagnosticMXBean;
import java.lang.management.ManagementFactory;
import java.util.Optional;

/** Options of the running JVM. */
public final class JvmOptions {
    private JvmOptions() {}

    /**
     * The value of an option by its name without {@code -XX:}; empty if this JVM does not know the option or does not
     * expose options.
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
