package dev.twister.engine.tornado;

import java.util.Map;

/** What TornadoVM must be told before its classes are loaded, whoever starts the JVM: {@code scripts/tornado.options}. */
final class TornadoOptions {
    static final Map<String, String> OPTIONS = Map.of(
            // A kernel that does not compile is an error, never a silent run of the Java code.
            "tornado.recover.bailout", "False",
            // TornadoVM's own choice, fast relaxed maths, moves pixels on some drivers.
            "tornado.opencl.compiler.flags", "-w",
            "tornado.enable.nativeFunctions", "False",
            // Without these two the kernel's helpers are left out of the device's code.
            "tornado.compiler.fullInlining", "True",
            "jdk.graal.MethodInlineBailoutLimit", "1000000",
            // The same for TornadoVM 6 and later.
            "graal.MethodInlineBailoutLimit", "1000000");

    private TornadoOptions() {}

    /** Sets each as a system property, over whatever it was. */
    static void set() {
        OPTIONS.forEach(System::setProperty);
    }
}
