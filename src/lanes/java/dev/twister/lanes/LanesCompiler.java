package dev.twister.lanes;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Makes the lanes of path tracing: {@code LanesCompiler <kernel's folder> <folder of generated sources>}. */
public final class LanesCompiler {
    private static final String PACKAGE = "dev.twister.engine.vector.made";

    /** The classes and the kernel's methods that they run. */
    private static final Map<String, String> ROOTS = Map.of(
            "StartLanes", "PathTracer.start",
            "FindLanes", "PathTracer.find",
            "LightLanes", "PathTracer.light",
            "ArriveLanes", "PathTracer.arrive");

    private LanesCompiler() {}

    /** Exits with 1 where the kernel has what lanes cannot be made of. */
    public static void main(String[] arguments) throws IOException {
        Path kernel = Path.of(arguments[0]);
        Path folder = Path.of(arguments[1]).resolve(PACKAGE.replace('.', '/'));
        Path compiler = Path.of(arguments[2]);
        if (!isUpToDate(folder, List.of(kernel, compiler))) {
            try {
                write(Sources.parse(javaFiles(kernel)), folder);
            } catch (Refusal refusal) {
                System.err.println("[ERROR] lanes cannot be made of the kernel: " + refusal.getMessage());
                System.exit(1);
            }
        }
    }

    private static List<Path> javaFiles(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(file -> file.toString().endsWith(".java"))
                    .sorted()
                    .toList();
        }
    }

    /** Whether the last class that is written is newer than all sources. */
    private static boolean isUpToDate(Path folder, Collection<Path> sources) throws IOException {
        Path last = folder.resolve("ColumnCounts.java");
        if (!Files.exists(last)) {
            return false;
        }
        FileTime made = Files.getLastModifiedTime(last);
        for (Path source : sources) {
            for (Path file : javaFiles(source)) {
                if (Files.getLastModifiedTime(file).compareTo(made) >= 0) {
                    return false;
                }
            }
        }
        return true;
    }

    private static void write(Sources sources, Path folder) throws IOException {
        Statements constants = new Statements(sources, new Builder(), 0);
        int pathLength = constants.constant("Layout", "LAYERED_PATH_LENGTH");
        int scratchLength = constants.constant("Layout", "LAYERED_SCRATCH_LENGTH");
        List<Integer> variants = variants(constants);
        Files.createDirectories(folder);
        List<Root> roots = new ArrayList<>();
        for (Map.Entry<String, String> root : ROOTS.entrySet()) {
            Root made =
                    new Root(sources, PACKAGE, root.getKey(), sources.method(root.getValue()), pathLength, variants);
            Files.writeString(folder.resolve(root.getKey() + ".java"), made.text);
            roots.add(made);
        }
        Files.writeString(folder.resolve("ColumnCounts.java"), counts(roots, scratchLength));
    }

    /**
     * All variants of traced paths that are pictures, with and without further layers, except finishes: these call
     * their methods from many places, each of which would be made.
     */
    private static List<Integer> variants(Statements constants) {
        int shift = constants.constant("Variant", "VIEW_SHIFT");
        int always = constants.constant("Variant", "PATH") | constants.constant("Variant", "MATERIALS");
        int never = constants.constant("Variant", "FINISH");
        List<Integer> variants = new ArrayList<>();
        for (int bits = 0; bits < 1 << shift; bits++) {
            for (String view : List.of("FULL", "GUIDED", "LAYERED", "CUT", "CUT_GUIDED", "CUT_LAYERED")) {
                if ((bits & always) == always && (bits & never) == 0) {
                    variants.add(bits | constants.constant("Views", view) << shift);
                }
            }
        }
        return variants;
    }

    private static String counts(List<Root> roots, int scratchLength) {
        Lines lines = new Lines();
        lines.add("package " + PACKAGE + ";");
        lines.add("");
        lines.add("/** Numbers of columns of the made lanes. */");
        lines.block("final class ColumnCounts", () -> {
            lines.add(
                    "static final int FLOATS = %d;",
                    roots.stream().mapToInt(root -> root.floats).max().orElse(0));
            lines.add(
                    "static final int INTS = %d;",
                    roots.stream().mapToInt(root -> root.ints).max().orElse(0));
            lines.add(
                    "static final int MASKS = %d;",
                    roots.stream().mapToInt(root -> root.masks).max().orElse(0));
            lines.add("static final int SCRATCH = %d;", scratchLength);
            lines.add(
                    "static final int LISTS = %d;",
                    roots.stream().mapToInt(root -> root.lists).max().orElse(0));
            lines.add("");
            lines.add("/** The path's floats that live from ray to ray. */");
            lines.add("static final int[] STATE = {%s};", state(roots));
            lines.add("");
            lines.add("private ColumnCounts() {}");
        });
        return lines.toString();
    }

    private static String state(List<Root> roots) {
        return roots.stream()
                .flatMap(root -> root.state.stream())
                .distinct()
                .sorted()
                .map(Object::toString)
                .collect(Collectors.joining(", "));
    }
}
