package dev.twister.bench;

import dev.twister.engine.JvmOptions;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The compiler of the JVM's hot methods. */
public enum Jit {
    C2 {
        @Override
        public boolean isHere() {
            return true;
        }

        // A JVM that does not know the option has nothing but C2.
        @Override
        public List<String> options() {
            return JvmOptions.value(USES_GRAAL).isPresent()
                    ? List.of("-XX:+UnlockExperimentalVMOptions", "-XX:-" + USES_GRAAL)
                    : List.of();
        }
    },
    GRAAL {
        @Override
        public boolean isHere() {
            return hasLibrary() || hasModule();
        }

        @Override
        public List<String> options() {
            return List.of("-XX:+UnlockExperimentalVMOptions", "-XX:+EnableJVMCI", "-XX:+" + USES_GRAAL);
        }
    };

    /** The JVM's option that takes Graal for C2's place. */
    static final String USES_GRAAL = "UseJVMCICompiler";

    /** Whether this JVM could run with it. */
    public abstract boolean isHere();

    /** What makes a JVM like this one run with it. */
    public abstract List<String> options();

    /** GraalVM has it. */
    private static boolean hasLibrary() {
        Path home = Path.of(System.getProperty("java.home"));
        return Stream.of("lib/libjvmcicompiler.so", "lib/libjvmcicompiler.dylib", "bin/jvmcicompiler.dll")
                .anyMatch(library -> Files.isRegularFile(home.resolve(library)));
    }

    /** A TornadoVM SDK brings it; the JDK's own module of that name is empty. */
    private static boolean hasModule() {
        return ModuleLayer.boot()
                .findModule("jdk.graal.compiler")
                .filter(module -> !module.getPackages().isEmpty())
                .isPresent();
    }
}
