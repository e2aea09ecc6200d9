package dev.twister.engine.vector;

import dev.twister.engine.JvmOptions;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.management.JMException;
import javax.management.ObjectName;

/**
 * Compiler directives for this package: which methods C2 always inlines, and which never. The launcher passes them in
 * {@code scripts/engine.options}; in other JVMs they are added at run time, before any of these methods is compiled.
 * Without them C2 allocates vectors as objects, and a frame takes four times as long.
 */
final class StageInlining {
    private static final String PACKAGE = "dev/twister/engine/vector/";

    /**
     * Methods that take or return vectors, and the lists: always inlined. The JDK's one is not by itself; where it is a
     * call, gathers allocate.
     */
    static final List<String> ALWAYS = List.of(PACKAGE + "lanes/*.*", "jdk/incubator/vector/IntVector.species");

    /**
     * Methods whose first parameter is a tile, its shadow columns or the columns of paths, and those that run once per
     * tile: never inlined.
     */
    static final List<String> NEVER = List.of(
            PACKAGE + "*.*(L" + PACKAGE + "lanes/Tile;",
            PACKAGE + "*.*(L" + PACKAGE + "lanes/ShadowColumns;",
            PACKAGE + "*.*(L" + PACKAGE + "made/PathColumns;",
            PACKAGE + "TileRenderer.*",
            PACKAGE + "BounceRenderer.*");

    /** Lanes made of the kernel: a thread that needs them waits until they are compiled. */
    private static final String MADE = PACKAGE + "made/*.*";

    private static final Logger LOGGER = System.getLogger(StageInlining.class.getName());

    private StageInlining() {}

    /** Adds the directives unless the launcher has passed them. */
    static void ensure() {
        if (!isToldByOptions()) {
            try {
                tell();
            } catch (IOException | JMException e) {
                LOGGER.log(
                        Level.WARNING,
                        "the engine vector is slow in this JVM, whose compiler takes no directives ({0}); start it with"
                                + " @scripts/engine.options",
                        e.getMessage());
            }
        }
    }

    private static boolean isToldByOptions() {
        String commands = JvmOptions.value("CompileCommand").orElse("");
        return NEVER.stream().allMatch(commands::contains);
    }

    private static void tell() throws IOException, JMException {
        Path file = Files.createTempFile("twister-", ".json");
        try {
            Files.writeString(file, directives());
            ManagementFactory.getPlatformMBeanServer()
                    .invoke(
                            new ObjectName("com.sun.management:type=DiagnosticCommand"),
                            "compilerDirectivesAdd",
                            new Object[] {new String[] {file.toString()}},
                            new String[] {String[].class.getName()});
        } finally {
            Files.deleteIfExists(file);
        }
    }

    /** The directives as JSON; see {@code jcmd}'s {@code Compiler.directives_add}. */
    private static String directives() {
        String inlining = Stream.concat(
                        ALWAYS.stream().map(methods -> "\"+" + methods + "\""),
                        NEVER.stream().map(methods -> "\"-" + methods + "\""))
                .collect(Collectors.joining(", "));
        return "[{match: \"" + MADE + "\", BackgroundCompilation: false, inline: [" + inlining + "]}, {match: \""
                + PACKAGE + "*.*\", inline: [" + inlining + "]}]";
    }
}
