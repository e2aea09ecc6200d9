package dev.twister.cli;

import dev.twister.bench.Jit;
import dev.twister.bench.JitReport;
import dev.twister.engine.EngineException;
import dev.twister.files.TemporaryFolder;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import tools.jackson.databind.JsonNode;

/**
 * The same command in JVMs like this one, each with another compiler.
 *
 * @param arguments of the command line, with its options {@value #JIT} and {@value #JSON}
 */
record JitRuns(List<String> arguments) {
    private static final String JIT = "--jit";
    private static final String JSON = "--json";

    /** What the JVM has from there is among its options already. */
    private static final List<String> VARIABLES = List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS", "_JAVA_OPTIONS");

    /**
     * Runs them one after the other; their progress is on this process's standard error.
     *
     * @throws BadInputException where this JVM has not one of the compilers
     * @throws EngineException where a JVM ends without a report
     */
    JitReport run(List<Jit> jits) throws IOException {
        for (Jit jit : jits) {
            if (!jit.isHere()) {
                throw new BadInputException(
                        "--jit is " + name(jit) + ", but the JDK in " + System.getProperty("java.home")
                                + " does not have it; set JAVA_HOME to a GraalVM, or install a TornadoVM SDK, which has Graal");
            }
        }
        Map<String, JsonNode> reports = new LinkedHashMap<>();
        try (TemporaryFolder folder = TemporaryFolder.create()) {
            Path json = folder.path().resolve("report.json");
            for (Jit jit : jits) {
                Files.deleteIfExists(json);
                reports.put(name(jit), run(jit, json, folder.path().resolve("options")));
            }
        }
        return new JitReport(reports);
    }

    private JsonNode run(Jit jit, Path json, Path options) throws IOException {
        // Windows' command lines are too short for an SDK's options.
        Files.write(
                options,
                jvmOptions(jit).stream().map(JitRuns::quoted).toList(),
                Charset.forName(System.getProperty("native.encoding", "UTF-8")));
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.add("@" + options);
        command.add(Main.class.getName());
        command.addAll(childArguments(json));
        ProcessBuilder builder = new ProcessBuilder(command)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.INHERIT);
        builder.environment().keySet().removeAll(VARIABLES);
        int code = waitFor(builder.start());
        if (Files.notExists(json)) {
            throw new EngineException(
                    "the benchmark with " + name(jit) + " ended with exit code " + code + " and without a report");
        }
        return JitReport.read(json);
    }

    private static int waitFor(Process child) {
        Thread hook = Thread.ofPlatform().name("end of the child").unstarted(child::destroy);
        Runtime.getRuntime().addShutdownHook(hook);
        int code = child.onExit().join().exitValue();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException _) {
            // The process ends already.
        }
        return code;
    }

    private static List<String> jvmOptions(Jit jit) {
        Stream<String> classPath = Stream.of("-cp", System.getProperty("java.class.path"));
        return Stream.of(
                        ManagementFactory.getRuntimeMXBean().getInputArguments().stream(),
                        jit.options().stream(),
                        classPath)
                .flatMap(options -> options)
                .toList();
    }

    /** As argument files of the JDK have it. */
    private static String quoted(String option) {
        return '"' + option.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }

    /** The command line without its own compilers and report, with another report. */
    List<String> childArguments(Path json) {
        List<String> kept = new ArrayList<>();
        boolean isValue = false;
        for (String argument : arguments) {
            boolean isOption = argument.equals(JIT) || argument.equals(JSON);
            boolean hasValue = argument.startsWith(JIT + "=") || argument.startsWith(JSON + "=");
            if (!isValue && !isOption && !hasValue) {
                kept.add(argument);
            }
            isValue = isOption && !isValue;
        }
        kept.add(JSON);
        kept.add(json.toString());
        return kept;
    }

    private static String name(Jit jit) {
        return jit.name().toLowerCase(Locale.ROOT);
    }
}
