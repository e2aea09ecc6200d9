package dev.twister.bench.benchmark;

import com.sun.management.OperatingSystemMXBean;
import dev.twister.engine.Processor;
import dev.twister.files.InputFile;
import dev.twister.files.TwisterVersion;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Properties;

/**
 * The machine and software of a benchmark.
 *
 * @param processor the CPU's model
 * @param cores number of cores available to this JVM
 * @param memoryBytes the machine's memory
 * @param maxHeapBytes this JVM's maximum heap
 * @param operatingSystem with version and architecture
 * @param jdk version
 * @param vendor the JDK's vendor, with its own version if it has one
 * @param jit C2 or Graal, with the JVM's name
 * @param twister version
 * @param tornadoVm version; empty if TornadoVM is not running
 */
public record MachineInfo(
        String processor,
        int cores,
        long memoryBytes,
        long maxHeapBytes,
        String operatingSystem,
        String jdk,
        String vendor,
        String jit,
        String twister,
        Optional<String> tornadoVm) {
    public static MachineInfo ofThisMachine() {
        return new MachineInfo(
                Processor.name(),
                Runtime.getRuntime().availableProcessors(),
                machineMemory(),
                Runtime.getRuntime().maxMemory(),
                System.getProperty("os.name") + " " + System.getProperty("os.version") + " "
                        + System.getProperty("os.arch"),
                System.getProperty("java.runtime.version", System.getProperty("java.version")),
                vendorAndVersion(),
                compilerAndJvm(),
                TwisterVersion.text(),
                TornadoVersion.find());
    }

    private static long machineMemory() {
        OperatingSystemMXBean system = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
        return system == null ? 0 : system.getTotalMemorySize();
    }

    private static String vendorAndVersion() {
        String own = System.getProperty("java.vendor.version", "");
        return System.getProperty("java.vendor", "unknown") + (own.isEmpty() ? "" : " (" + own + ")");
    }

    private static String compilerAndJvm() {
        return (Jit.running() == Jit.GRAAL ? "Graal" : "C2") + ", " + System.getProperty("java.vm.name", "unknown JVM");
    }

    /** Version of TornadoVM in this JVM, from a file of its SDK, without loading its classes. */
    private static final class TornadoVersion {
        private static final int MOST_BYTES = 1 << 16;

        private TornadoVersion() {}

        static Optional<String> find() {
            if (ModuleLayer.boot().findModule("tornado.runtime").isEmpty()) {
                return Optional.empty();
            }
            return Optional.of(Optional.ofNullable(System.getenv("TORNADOVM_HOME"))
                    .flatMap(sdk -> version(Path.of(sdk, "etc", "tornado.release")))
                    .orElse("unknown"));
        }

        private static Optional<String> version(Path release) {
            Properties properties = new Properties();
            try {
                properties.load(new ByteArrayInputStream(InputFile.readSmall(release, MOST_BYTES)));
            } catch (IOException | IllegalArgumentException notReadable) {
                return Optional.empty();
            }
            return Optional.ofNullable(properties.getProperty("version"));
        }
    }
}
