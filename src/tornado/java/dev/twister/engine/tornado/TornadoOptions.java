package dev.twister.engine.tornado;

import java.util.Map;

/**
 * Options for TornadoVM that must be set before its classes are loaded, also in JVMs that are started without
 * {@code scripts/tornado.options}.
 */
final class TornadoOptions {
    private static final String GRAAL = "jdk.graal.compiler";

    private TornadoOptions() {}

    /** Sets the options as system properties, overriding earlier values. */
    static void set() {
        options(ModuleLayer.boot().findModule(GRAAL).isPresent()).forEach(System::setProperty);
    }

    /**
     * The options by name.
     *
     * @param isJdkGraal whether TornadoVM's compiler is {@code jdk.graal.compiler}, which needs the prefix
     *     {@code jdk.graal.} and warns about the other one; the Graal of TornadoVM 6 knows only {@code graal.}
     */
    static Map<String, String> options(boolean isJdkGraal) {
        return Map.of(
                // A kernel that does not compile must be an error, not a silent fallback to Java.
                "tornado.recover.bailout",
                "False",
                // TornadoVM's default, fast relaxed math, changes pixels on some drivers.
                "tornado.opencl.compiler.flags",
                "-w",
                "tornado.enable.nativeFunctions",
                "False",
                // A fused multiply-add rounds once where Java rounds twice, which repeated reflections make visible.
                "tornado.enable.fma",
                "False",
                // Without these two, helpers of the kernel are missing in the device code.
                "tornado.compiler.fullInlining",
                "True",
                (isJdkGraal ? "jdk.graal." : "graal.") + "MethodInlineBailoutLimit",
                "1000000");
    }
}
