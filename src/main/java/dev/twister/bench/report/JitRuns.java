package dev.twister.bench.report;

import dev.twister.bench.benchmark.Jit;
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
import java.util.Map;
import java.util.stream.Stream;
import tools.jackson.databind.JsonNode;

/**
 * Runs a benchmark command in JVMs like this one, each with another compiler.
 *
 * @param program name of the class with the main method
 * @param arguments of the command line, with its options {@value #JIT} and {@value #JSON}
 */
public record JitRuns(String program, List<String> arguments) {
    private static final String JIT = "--jit";
    private static final String JSON = "--json";

    /** Environment variables whose options this JVM already has. */
    private static final List<String> VARIABLES = List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS", "_JAVA_OPTIONS");

    /**
     * Runs the command once per compiler; progress goes to this process's standard error.
     *
     * @param jits compilers that this JVM has
     * @throws EngineException if a JVM ends without a report
     * @throws IOException if a temporary file cannot be written
     */
    public JitReport run(List<Jit> jits) throws IOException {
        Map<String, JsonNode> reports = new LinkedHashMap<>();
        try (TemporaryFolder folder = TemporaryFolder.create()) {
            Path json = folder.path().resolve("report.json");
            for (Jit jit : jits) {
                Files.deleteIfExists(json);
                reports.put(jit.id(), run(jit, json, folder.path().resolve("options")));
            }
        }
        return new JitReport(reports);
    }

    private JsonNode run(Jit jit, Path json, Path options) throws IOException {
        // The options of an SDK exceed the length of command lines on Windows.
        Files.write(
                options,
                jvmOptions(jit).stream().map(JitRuns::quoted).toList(),
                Charset.forName(System.getProperty("native.encoding", "UTF-8")));
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.add("@" + options);
        command.add(program);
        command.addAll(childArguments(json));
        ProcessBuilder builder = new ProcessBuilder(command)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.INHERIT);
        builder.environment().keySet().removeAll(VARIABLES);
        int code = waitFor(builder.start());
        if (Files.notExists(json)) {
            throw new EngineException(
                    "the benchmark with " + jit.id() + " ended with exit code " + code + " and without a report");
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
            // The process is ending.
        }
        return code;
    }

    private static List<String> jvmOptions(Jit jit) {
        Stream<String> classPath = Stream.of("-cp", System.getProperty("java.class.path"));
        return Stream.of(
                        // Children have no other descriptors than the usual three.
                        ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
                                .filter(option -> !option.startsWith("-Dtwister.stderr=")),
                        jit.options().stream(),
                        classPath)
                .flatMap(options -> options)
                .toList();
    }

    /** Quotes an option for the JDK's argument files. */
    private static String quoted(String option) {
        return '"' + option.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }

    /** The command line without its compilers, with another report file. */
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
}
