package dev.twister.engine.tornado;

import java.util.Map;

/**
 * What TornadoVM must be told before its classes are loaded, however the JVM is started:
 * {@code scripts/tornado.options}.
 */
final class TornadoOptions {
    private static final String GRAAL = "jdk.graal.compiler";

    private TornadoOptions() {}

    /** Sets each as a system property, over whatever it was. */
    static void set() {
        options(ModuleLayer.boot().findModule(GRAAL).isPresent()).forEach(System::setProperty);
    }

    /**
     * The options by name.
     *
     * @param isJdkGraal whether TornadoVM's compiler is {@code jdk.graal.compiler}, which takes its options by that
     *     prefix and warns of the other; the Graal of TornadoVM 6 knows the other alone
     */
    static Map<String, String> options(boolean isJdkGraal) {
        return Map.of(
                // A kernel that does not compile is an error, never a silent run of the Java code.
                "tornado.recover.bailout",
                "False",
                // TornadoVM's own choice, fast relaxed math, moves pixels on some drivers.
                "tornado.opencl.compiler.flags",
                "-w",
                "tornado.enable.nativeFunctions",
                "False",
                // A fused multiply-add rounds once where the kernel's Java rounds twice; mirrors of mirrors show it.
                "tornado.enable.fma",
                "False",
                // Without these two the kernel's helpers are left out of the device's code.
                "tornado.compiler.fullInlining",
                "True",
                (isJdkGraal ? "jdk.graal." : "graal.") + "MethodInlineBailoutLimit",
                "1000000");
    }
}
