package dev.twister.engine;

import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.util.Optional;

/** Whether the JVM's compiler has finished anything since it was last asked: code that is compiled anew is faster soon. */
final class CompilerActivity {
    private final Optional<CompilationMXBean> compiler = Optional.ofNullable(ManagementFactory.getCompilationMXBean())
            .filter(CompilationMXBean::isCompilationTimeMonitoringSupported);

    private long compiledMillis;

    boolean sinceLastAsked() {
        long before = compiledMillis;
        compiledMillis =
                compiler.map(CompilationMXBean::getTotalCompilationTime).orElse(before);
        return compiledMillis > before;
    }
}
