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
 * What the JVM's compiler must know of this package: which methods it always inlines, and which never. The launcher
 * tells it in {@code scripts/jvm.options}; a JVM that somebody else starts is told while it runs, before any of them is
 * compiled. Untold, it makes objects of vectors, and frames take four times as long.
 */
final class StageInlining {
    private static final String PACKAGE = "dev/twister/engine/vector/";

    /** What takes or returns vectors, and lists: always inlined. */
    static final List<String> ALWAYS = List.of(PACKAGE + "lanes/*.*");

    /**
     * What has a tile's or a shadow's columns as its first parameter, and so works on them; and what runs once a tile.
     */
    static final List<String> NEVER = List.of(
            PACKAGE + "*.*(L" + PACKAGE + "lanes/Tile;",
            PACKAGE + "*.*(L" + PACKAGE + "lanes/ShadowColumns;",
            PACKAGE + "TileRenderer.*");

    private static final Logger LOGGER = System.getLogger(StageInlining.class.getName());

    private StageInlining() {}

    /** Tells the compiler where the launcher has not. */
    static void ensure() {
        if (!isToldByOptions()) {
            try {
                tell();
            } catch (IOException | JMException e) {
                LOGGER.log(
                        Level.WARNING,
                        "the engine vector is slow in this JVM, whose compiler takes no directives ({0}); start it with"
                                + " @scripts/jvm.options",
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

    /** In the JVM's own form, see {@code jcmd}'s {@code Compiler.directives_add}. */
    private static String directives() {
        String inlining = Stream.concat(
                        ALWAYS.stream().map(methods -> "\"+" + methods + "\""),
                        NEVER.stream().map(methods -> "\"-" + methods + "\""))
                .collect(Collectors.joining(", "));
        return "[{match: \"" + PACKAGE + "*.*\", inline: [" + inlining + "]}]";
    }
}
