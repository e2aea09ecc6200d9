package dev.twister.bench.benchmark;

import dev.twister.engine.JvmOptions;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** The JVM's optimizing JIT compiler. */
public enum Jit {
    C2 {
        @Override
        public boolean isHere() {
            return true;
        }

        // A JVM without the option has only C2.
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

    /** The JVM option that replaces C2 by Graal. */
    static final String USES_GRAAL = "UseJVMCICompiler";

    /** The one that compiles this JVM's code. */
    public static Jit running() {
        return JvmOptions.value(USES_GRAAL).filter("true"::equals).isPresent() ? GRAAL : C2;
    }

    /** Name for commands and reports. */
    public String id() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Whether this JVM can use it. */
    public abstract boolean isHere();

    /** Options with which a JVM like this one uses it. */
    public abstract List<String> options();

    /** Included in GraalVM. */
    private static boolean hasLibrary() {
        Path home = Path.of(System.getProperty("java.home"));
        return Stream.of("lib/libjvmcicompiler.so", "lib/libjvmcicompiler.dylib", "bin/jvmcicompiler.dll")
                .anyMatch(library -> Files.isRegularFile(home.resolve(library)));
    }

    /** Included in a TornadoVM SDK; the JDK's own module of that name is empty. */
    private static boolean hasModule() {
        return ModuleLayer.boot()
                .findModule("jdk.graal.compiler")
                .filter(module -> !module.getPackages().isEmpty())
                .isPresent();
    }
}
