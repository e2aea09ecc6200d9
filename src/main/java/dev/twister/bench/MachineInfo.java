package dev.twister.bench;

import dev.twister.engine.Processor;
import dev.twister.files.TwisterVersion;
import java.util.Optional;

/**
 * What a benchmark ran on.
 *
 * @param processor its model's name
 * @param cores that this JVM may use
 * @param memoryBytes of the machine
 * @param maxHeapBytes that this JVM may use
 * @param operatingSystem with version and architecture
 * @param jdk version
 * @param vendor the JDK's vendor, with its own version where it has one
 * @param jit C2, or Graal, with the JVM's name
 * @param twister version
 * @param tornadoVm version; empty where it does not run
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
                Jvm.machineMemory(),
                Runtime.getRuntime().maxMemory(),
                System.getProperty("os.name") + " " + System.getProperty("os.version") + " "
                        + System.getProperty("os.arch"),
                System.getProperty("java.runtime.version", System.getProperty("java.version")),
                Jvm.vendor(),
                Jvm.jit(),
                TwisterVersion.text(),
                TornadoVersion.find());
    }
}
